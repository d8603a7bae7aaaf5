//! What answers the browser, on this machine alone.

use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use oxhttp::model::header::{CACHE_CONTROL, CONTENT_ENCODING, CONTENT_TYPE};
use oxhttp::model::{Body, HeaderValue, Method, Request, Response, StatusCode};
use oxhttp::{ListeningServer, Server as Http};

use super::asker::{is_for_here, is_own_page};
use super::files;
use super::frames::frames;
use super::shown::Shown;
use crate::simulate::{RunError, Summary};

/// Between two looks at whether it is to end.
const BETWEEN_LOOKS: Duration = Duration::from_millis(50);
/// More connections than a few browser windows open.
const MOST_CONNECTIONS: usize = 128;
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

/// What hears of a run of what is shown, when it has ended.
pub type Tell = fn(&Shown, &Result<Summary, RunError>);

/// A server of one scene.
pub struct Server {
    address: SocketAddr,
    http: ListeningServer,
}

impl Server {
    /// Listens on a port of the loopback interface; 0 is any that is free. Runs that pages look at end when `interrupted`;
    /// what became of each is given to `tell`.
    ///
    /// # Errors
    /// If the port is taken, or may not be used.
    pub fn listen(port: u16, shown: Shown, tell: Tell, interrupted: &'static AtomicBool) -> Result<Self, ServerError> {
        let refused = |source| ServerError { port, source };
        let address = free_address(port).map_err(refused)?;
        let shown = Arc::new(shown);
        let http = Http::new(move |request| answer(request, address.port(), &shown, tell, interrupted))
            .bind(address)
            .with_max_concurrent_connections(MOST_CONNECTIONS)
            .spawn()
            .map_err(refused)?;
        Ok(Self { address, http })
    }

    /// Where it listens.
    #[must_use]
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Answers until it is interrupted; its threads end with the program.
    pub fn serve_until(self, interrupted: &AtomicBool) {
        while !interrupted.load(Ordering::Relaxed) {
            thread::sleep(BETWEEN_LOOKS);
        }
        drop(self.http);
    }
}

/// The address of a port: the server itself cannot tell which one it was given.
fn free_address(port: u16) -> io::Result<SocketAddr> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port))?.local_addr()
}

fn answer(
    request: &Request<Body>,
    port: u16,
    shown: &Arc<Shown>,
    tell: Tell,
    interrupted: &'static AtomicBool,
) -> Response<Body> {
    if !is_for_here(request.headers(), port) {
        return refusal(StatusCode::FORBIDDEN, "this server is for pages of this machine");
    }
    if *request.method() != Method::GET {
        return refusal(StatusCode::METHOD_NOT_ALLOWED, "there is nothing here but to GET");
    }
    let path = request.uri().path().trim_start_matches('/');
    // A page of another site cannot read the answer, but to ask is to start a run.
    if path.starts_with("desktop/") && !is_own_page(request.headers(), port) {
        return refusal(StatusCode::FORBIDDEN, "the run is for the page that is served here");
    }
    match path {
        "" | "index.html" => of(page(), "text/html; charset=utf-8"),
        "desktop/scene.json" => of(shown.texts.json(), "application/json"),
        "desktop/frames" => {
            of(Body::from_read(frames(Arc::clone(shown), tell, interrupted)), "application/octet-stream")
        }
        path => match files::at(path) {
            Some(file) => {
                let mut response = of(file.bytes, file.kind);
                if file.is_packed {
                    response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
                }
                response
            }
            None => refusal(StatusCode::NOT_FOUND, "there is no such file here"),
        },
    }
}

/// The page, marked as coming from here.
fn page() -> Vec<u8> {
    let page = files::at("").map_or(&[][..], |file| file.bytes);
    String::from_utf8_lossy(page).replacen("<title>", MARK, 1).into_bytes()
}

fn of(body: impl Into<Body>, kind: &'static str) -> Response<Body> {
    let mut response = Response::new(body.into());
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    response.headers_mut().insert(CACHE_CONTROL, HeaderValue::from_static("no-cache"));
    response
}

fn refusal(status: StatusCode, words: &'static str) -> Response<Body> {
    let mut response = of(words, "text/plain; charset=utf-8");
    *response.status_mut() = status;
    response
}
