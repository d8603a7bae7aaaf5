//! Who is answered by `hooke view`.
#![allow(clippy::unwrap_used, missing_docs)]

use hooke_runner::view::{is_for_here, is_own_page};
use oxhttp::model::header::{HOST, HeaderMap, HeaderName, ORIGIN};

fn with(headers: &[(HeaderName, &'static str)]) -> HeaderMap {
    headers.iter().map(|(name, value)| (name.clone(), value.parse().unwrap())).collect()
}

#[test]
fn this_machine_is_named_with_its_port_and_port_80_without() {
    let asked = |host, port| is_for_here(&with(&[(HOST, host)]), port);
    assert!(asked("127.0.0.1:8080", 8080) && asked("localhost:8080", 8080));
    assert!(asked("127.0.0.1", 80) && asked("localhost", 80) && asked("localhost:80", 80));
    // A port that is left out is 80 and no other.
    assert!(!asked("localhost", 8080) && !asked("127.0.0.1", 8080) && !asked("localhost:8081", 8080));
    assert!(!asked("example.org", 80) && !asked("example.org:8080", 8080));
    assert!(!is_for_here(&HeaderMap::new(), 80));
}

#[test]
fn pages_of_other_sites_are_told_apart() {
    let site = HeaderName::from_static("sec-fetch-site");
    let own = |headers: &[_]| is_own_page(&with(headers), 8080);
    assert!(own(&[]) && own(&[(site.clone(), "none")]));
    assert!(own(&[(ORIGIN, "http://localhost:8080"), (site.clone(), "same-origin")]));
    for origin in ["https://example.org", "http://localhost:3000", "http://localhost", "https://localhost:8080", "null"]
    {
        assert!(!own(&[(ORIGIN, origin)]), "{origin}");
    }
    for other in ["cross-site", "same-site"] {
        assert!(!own(&[(site.clone(), other)]), "{other}");
    }
}
