//! Server of one page at three addresses, for browsers on this machine only.

use std::io::{self, Write};
use std::net::Ipv4Addr;
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use tiny_http::{Header, Method, Request, Response, Server};

use super::site::Site;
use crate::failure::Failure;

/// Interval of messages without news. A closed browser is noticed only when a message is sent.
const PULSE: Duration = Duration::from_secs(15);
/// Milliseconds after which a browser that has lost the server asks again.
const RETRY: u64 = 500;

/// Headers that keep pages of other sites from showing or reading this one.
const HEADERS: [(&str, &str); 5] = [
    ("Cache-Control", "no-store"),
    ("X-Content-Type-Options", "nosniff"),
    ("X-Frame-Options", "DENY"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
    ("Referrer-Policy", "no-referrer"),
];

/// Starts to serve a site at a port of this machine, or at a free one. Returns the port.
pub fn start(site: &Arc<Site>, port: Option<u16>) -> Result<u16, Failure> {
    let wanted = port.unwrap_or(0);
    let server = Server::http((Ipv4Addr::LOCALHOST, wanted)).map_err(|error| {
        let help = "without `--port` a free port is used";
        let message = format!("cannot serve at {}:{wanted}: {error}", Ipv4Addr::LOCALHOST);
        Failure::unsuccessful(message, if port.is_some() { help } else { "" })
    })?;
    let port = server.server_addr().to_ip().map_or(wanted, |address| address.port());
    let site = Arc::clone(site);
    thread::spawn(move || {
        for request in server.incoming_requests() {
            // Failure means that the browser no longer waits for its answer.
            let _ = answer(request, &site, port);
        }
    });
    Ok(port)
}

fn answer(request: Request, site: &Arc<Site>, port: u16) -> io::Result<()> {
    if !is_for(&request, port) {
        return refuse(request, 403, "requests must use the address of this server");
    }
    if *request.method() != Method::Get {
        return refuse(request, 405, "only GET requests are supported");
    }
    match request.url() {
        "/" => respond(request, 200, "text/html", site.page()),
        "/content" => respond(request, 200, "application/json", site.content()),
        "/events" => {
            let site = Arc::clone(site);
            // The thread lives as long as the browser stays.
            thread::spawn(move || send_events(request, &site));
            Ok(())
        }
        _ => refuse(request, 404, "there is no such page"),
    }
}

/// True if a request names this server as its host. A request under another name comes from a page
/// whose own domain name was made to point here.
fn is_for(request: &Request, port: u16) -> bool {
    let mut hosts = request.headers().iter().filter(|header| header.field.equiv("Host"));
    let (Some(host), None) = (hosts.next(), hosts.next()) else { return false };
    let host = host.value.as_str();
    [format!("127.0.0.1:{port}"), format!("localhost:{port}")].iter().any(|own| own == host)
        || port == 80 && ["127.0.0.1", "localhost"].contains(&host)
}

fn refuse(request: Request, code: u16, why: &str) -> io::Result<()> {
    respond(request, code, "text/plain", format!("{why}\n"))
}

fn respond(request: Request, code: u16, kind: &str, body: String) -> io::Result<()> {
    let kind = format!("{kind}; charset=utf-8");
    let mut response = Response::from_string(body).with_status_code(code);
    let headers = HEADERS.into_iter().chain([("Content-Type", kind.as_str())]);
    for header in headers.filter_map(|(name, value)| Header::from_bytes(name, value).ok()) {
        response.add_header(header);
    }
    request.respond(response)
}

/// Sends the state now and whenever it changes, until the browser closes.
fn send_events(request: Request, site: &Site) {
    let mut out = request.into_writer();
    // The response has no length, because it ends with the connection.
    let mut head =
        "HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Type: text/event-stream\r\n".to_owned();
    for (name, value) in HEADERS {
        head.extend([name, ": ", value, "\r\n"]);
    }
    let mut known = None;
    let mut sent = send(&mut out, &format!("{head}\r\nretry: {RETRY}\n\n"));
    while sent.is_ok() {
        sent = match site.changed_since(known, PULSE) {
            Some((version, word)) => {
                known = Some(version);
                send(&mut out, &format!("id: {version}\ndata: {word}\n\n"))
            }
            None => send(&mut out, ":\n\n"),
        };
    }
}

fn send(out: &mut impl Write, text: &str) -> io::Result<()> {
    out.write_all(text.as_bytes())?;
    out.flush()
}
