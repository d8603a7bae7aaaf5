//! What answers the browser, on this machine alone.

use std::io::{self, Cursor};
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use tiny_http::{Header, Method, Request, Response, StatusCode};

use super::files;
use super::frames::frames;
use super::shown::Shown;

/// Between two looks at whether it is to end.
const BETWEEN_LOOKS: Duration = Duration::from_millis(100);
/// What the page looks for to know that a desktop is behind it.
const MARK: &str = "<meta name=\"hooke-desktop\" content=\"1\">\n<title>";

/// Why there is no server.
#[derive(Debug, thiserror::Error)]
#[error("nothing can be served on port {port} of this machine: {source}")]
pub struct ServerError {
    /// That was asked for; 0 is any.
    pub port: u16,
    /// Why not.
    pub source: io::Error,
}

/// A server of one scene.
pub struct Server {
    http: tiny_http::Server,
    shown: Arc<Shown>,
}

impl Server {
    /// Listens on a port of the loopback interface; 0 is any that is free.
    ///
    /// # Errors
    /// If the port is taken, or may not be used.
    pub fn listen(port: u16, shown: Shown) -> Result<Self, ServerError> {
        let http = tiny_http::Server::http((Ipv4Addr::LOCALHOST, port)).map_err(|error| {
            let source = error.downcast::<io::Error>().map_or_else(io::Error::other, |error| *error);
            ServerError { port, source }
        })?;
        Ok(Self { http, shown: Arc::new(shown) })
    }

    /// Where it listens.
    #[must_use]
    pub fn address(&self) -> Option<SocketAddr> {
        self.http.server_addr().to_ip()
    }

    /// Answers until it is interrupted.
    ///
    /// # Errors
    /// If no more can be received.
    pub fn serve(&self, interrupted: &'static AtomicBool) -> io::Result<()> {
        while !interrupted.load(Ordering::Relaxed) {
            let Some(request) = self.http.recv_timeout(BETWEEN_LOOKS)? else { continue };
            let shown = Arc::clone(&self.shown);
            let own = self.address();
            // A stream of frames lasts as long as somebody looks at it.
            thread::spawn(move || answer(request, own, shown, interrupted));
        }
        Ok(())
    }
}

/// A browser that has gone away needs no answer, and no error.
fn answer(request: Request, own: Option<SocketAddr>, shown: Arc<Shown>, interrupted: &'static AtomicBool) {
    let path = request.url().split(['?', '#']).next().unwrap_or_default().trim_start_matches('/').to_owned();
    let _ = if !is_for_here(&request, own) {
        request.respond(refusal(403, "this server is for pages of this machine"))
    } else if *request.method() != Method::Get {
        request.respond(refusal(405, "there is nothing here but to GET"))
    } else if path == "desktop/frames" {
        let headers = [header("Content-Type", "application/octet-stream"), header("Cache-Control", "no-store")];
        let headers = headers.into_iter().flatten().collect();
        request.respond(Response::new(StatusCode(200), headers, frames(shown, interrupted), None, None))
    } else if path == "desktop/scene.json" {
        request.respond(of_bytes(shown.json(), "application/json"))
    } else if path.is_empty() || path == "index.html" {
        request.respond(of_bytes(page(), "text/html; charset=utf-8"))
    } else if let Some(file) = files::at(&path) {
        let response = of_bytes(file.bytes.to_vec(), file.kind);
        let packed = file.is_packed.then(|| header("Content-Encoding", "gzip")).flatten();
        request.respond(packed.into_iter().fold(response, Response::with_header))
    } else {
        request.respond(refusal(404, "there is no such file here"))
    };
}

/// Whether a request names this machine: a page from elsewhere that was made to resolve to it does not.
fn is_for_here(request: &Request, own: Option<SocketAddr>) -> bool {
    let port = own.map_or(0, |own| own.port());
    let host = request.headers().iter().find(|header| header.field.equiv("Host"));
    host.is_some_and(|host| ["127.0.0.1", "localhost"].iter().any(|name| host.value.as_str() == format!("{name}:{port}")))
}

/// The page, marked as coming from here.
fn page() -> Vec<u8> {
    let page = files::at("").map_or_else(Vec::new, |file| file.bytes.to_vec());
    String::from_utf8_lossy(&page).replacen("<title>", MARK, 1).into_bytes()
}

/// A header; none where a name or a value is not plain ASCII, as all in here are.
fn header(name: &str, value: &str) -> Option<Header> {
    Header::from_bytes(name, value).ok()
}

fn of_bytes(bytes: Vec<u8>, of: &str) -> Response<Cursor<Vec<u8>>> {
    let headers = [header("Content-Type", of), header("Cache-Control", "no-cache")];
    headers.into_iter().flatten().fold(Response::from_data(bytes), Response::with_header)
}

fn refusal(code: u16, words: &str) -> Response<Cursor<Vec<u8>>> {
    Response::from_string(words).with_status_code(code)
}
