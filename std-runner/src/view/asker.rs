//! Who asks: a browser says which name it was led here by, and which site's page it asks for.

use oxhttp::model::header::{HOST, HeaderMap, HeaderName, ORIGIN};

/// The names of this machine that are answered.
const NAMES: [&str; 2] = ["127.0.0.1", "localhost"];
/// A port that browsers leave out.
const UNSAID: u16 = 80;
const SITE: HeaderName = HeaderName::from_static("sec-fetch-site");

/// Whether headers name this machine and this port: those of a page from elsewhere that was made to resolve to it do not.
#[must_use]
pub fn is_for_here(headers: &HeaderMap, port: u16) -> bool {
    let host = headers.get(HOST).and_then(|host| host.to_str().ok());
    host.is_some_and(|host| is_here(host, port))
}

/// Whether headers are those of this server's own page, or of nothing that says which page it is, such as an address that
/// was typed in.
#[must_use]
pub fn is_own_page(headers: &HeaderMap, port: u16) -> bool {
    let is_own_origin = headers.get(ORIGIN).is_none_or(|origin| {
        let host = origin.to_str().ok().and_then(|origin| origin.strip_prefix("http://"));
        host.is_some_and(|host| is_here(host, port))
    });
    is_own_origin && headers.get(SITE).is_none_or(|site| site == "same-origin" || site == "none")
}

fn is_here(host: &str, port: u16) -> bool {
    NAMES.iter().any(|name| host == format!("{name}:{port}") || port == UNSAID && host == *name)
}
