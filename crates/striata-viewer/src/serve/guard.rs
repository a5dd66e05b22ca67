//! Checks and headers for every request: which hosts are answered, and what browsers may do with responses.
//!
//! A page of another site can make a browser send requests to a server on the same machine under a host name
//! that the site resolves to this machine (DNS rebinding); the browser would then treat it as a page of this
//! server. So a server that is bound to a loopback address only answers requests for loopback host names, and
//! for the names of proxies that its user has allowed.

use std::net::{IpAddr, Ipv6Addr};
use std::str::FromStr;
use std::sync::Arc;

use axum::Router;
use axum::extract::{Request, State};
use axum::http::header::{
    ACCEPT_RANGES, CONTENT_LENGTH, CONTENT_RANGE, CONTENT_SECURITY_POLICY, ETAG, HOST, IF_RANGE, RANGE,
    REFERRER_POLICY, X_CONTENT_TYPE_OPTIONS,
};
use axum::http::uri::Authority;
use axum::http::{HeaderName, HeaderValue, Method, StatusCode};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::{IntoResponse, Response};
use tower_http::cors::{Any, CorsLayer};
use tower_http::set_header::SetResponseHeaderLayer;

/// Allows our own scripts, wasm, and workers made from them; nothing from other origins.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval' blob:; \
                      worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; \
                      font-src 'self' data:; connect-src 'self' data: blob:; object-src 'none'; \
                      base-uri 'none'; form-action 'none'; \
                      frame-ancestors 'self'";

/// Hosts that a server answers for.
#[derive(Clone, Debug)]
pub(super) enum Hosts {
    /// All; for servers that other machines can reach anyway.
    Any,
    /// Loopback names and addresses, and the names of proxies.
    Loopback(Arc<[HostName]>),
}

impl Hosts {
    /// Whether requests for an authority (a host with or without a port) are answered.
    fn includes(&self, authority: &str) -> bool {
        let Self::Loopback(proxies) = self else { return true };
        let Ok(authority) = authority.parse::<Authority>() else { return false };
        let host = without_dot(authority.host());
        let has_user = authority.as_str().contains('@');
        !has_user
            && (is_loopback(host) || proxies.iter().any(|HostName(proxy)| proxy.eq_ignore_ascii_case(host)))
    }
}

/// Name or address of a host, without a port. Compared without regard to case or to a dot at the end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HostName(String);

impl FromStr for HostName {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let bare = text.strip_prefix('[').and_then(|text| text.strip_suffix(']')).unwrap_or(text);
        if let Ok(address) = bare.parse::<Ipv6Addr>() {
            // In requests, an IPv6 address has brackets.
            return Ok(Self(format!("[{address}]")));
        }
        let is_allowed = |letter: char| letter.is_ascii_alphanumeric() || "-._".contains(letter);
        match without_dot(text) {
            name if !name.is_empty() && name.chars().all(is_allowed) => Ok(Self(name.to_owned())),
            _ => Err("expected the name or address of a host, without scheme, port or path".to_owned()),
        }
    }
}

fn without_dot(host: &str) -> &str {
    host.strip_suffix('.').unwrap_or(host)
}

/// Wraps the routes in all checks and headers.
pub(super) fn guarded(router: Router, hosts: Hosts, allows_other_sites: bool) -> Router {
    let header = |name: HeaderName, value: &'static str| {
        SetResponseHeaderLayer::overriding(name, HeaderValue::from_static(value))
    };
    let sharing = if allows_other_sites { "cross-origin" } else { "same-origin" };
    let router = if allows_other_sites { router.layer(cross_site()) } else { router };
    router
        .layer(from_fn_with_state(hosts, check_host))
        .layer(header(X_CONTENT_TYPE_OPTIONS, "nosniff"))
        .layer(header(CONTENT_SECURITY_POLICY, POLICY))
        .layer(header(REFERRER_POLICY, "no-referrer"))
        .layer(header(HeaderName::from_static("cross-origin-resource-policy"), sharing))
}

fn cross_site() -> CorsLayer {
    CorsLayer::new()
        .allow_origin(Any)
        .allow_methods([Method::GET, Method::HEAD])
        .allow_headers([RANGE, IF_RANGE])
        .expose_headers([ETAG, CONTENT_LENGTH, CONTENT_RANGE, ACCEPT_RANGES])
}

async fn check_host(State(hosts): State<Hosts>, request: Request, next: Next) -> Response {
    let mut named = request.headers().get_all(HOST).iter();
    let (host, others) = (named.next(), named.count());
    let Some(host) = host.and_then(|host| host.to_str().ok()).filter(|_| others == 0) else {
        return (StatusCode::BAD_REQUEST, "exactly one Host header is required\n").into_response();
    };
    let target = request.uri().authority().map_or(host, Authority::as_str);
    if !(hosts.includes(host) && hosts.includes(target)) {
        let text = "this server only answers requests for localhost; start it with --allow-host to allow \
                    the name of a proxy, or with --host to allow other machines\n";
        return (StatusCode::MISDIRECTED_REQUEST, text).into_response();
    }
    next.run(request).await
}

/// Whether a host is a loopback name or address, which no other site can use.
fn is_loopback(host: &str) -> bool {
    let bare = host.strip_prefix('[').and_then(|host| host.strip_suffix(']')).unwrap_or(host);
    host.eq_ignore_ascii_case("localhost") || bare.parse::<IpAddr>().is_ok_and(|ip| ip.is_loopback())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hosts(proxies: &[&str]) -> Hosts {
        Hosts::Loopback(proxies.iter().map(|name| name.parse().expect("a host")).collect())
    }

    #[test]
    fn a_local_server_answers_for_loopback_names() {
        for good in
            ["localhost", "LOCALHOST:7878", "localhost.", "127.0.0.1", "127.0.0.1:1", "[::1]", "[::1]:7878"]
        {
            assert!(hosts(&[]).includes(good), "{good}");
        }
        for bad in [
            "",
            "example.com",
            "localhost.example.com",
            "127.0.0.1.example.com",
            "192.168.1.2",
            "0.0.0.0",
            "localhost@evil.com",
            "evil@localhost",
            "[::2]:1",
            "::1",
            "local host",
        ] {
            assert!(!hosts(&[]).includes(bad), "{bad}");
            assert!(!hosts(&["models.example"]).includes(bad), "{bad}");
            assert!(Hosts::Any.includes(bad), "{bad}");
        }
    }

    #[test]
    fn allowed_names_are_compared_without_port_and_case() {
        let hosts = hosts(&["Models.Example", "10.0.0.7", "2001:DB8::1"]);
        for good in [
            "models.example",
            "MODELS.example:443",
            "models.example.",
            "10.0.0.7:80",
            "[2001:db8::1]:8080",
            "localhost",
        ] {
            assert!(hosts.includes(good), "{good}");
        }
        for bad in ["example", "a.models.example", "models.example.com", "evil@models.example", "10.0.0.70"] {
            assert!(!hosts.includes(bad), "{bad}");
        }
    }

    #[test]
    fn host_names_have_no_port_scheme_or_path() {
        for bad in ["", ".", "a:80", "https://a", "a/b", "user@a", "a b", "*", "[::1]:80", "[::1", "[a]"] {
            assert!(bad.parse::<HostName>().is_err(), "{bad}");
        }
        assert_eq!("[::1]".parse(), Ok(HostName("[::1]".to_owned())));
    }
}
