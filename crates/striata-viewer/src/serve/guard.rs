//! Checks and headers for every request: which hosts are answered, and what browsers may do with responses.
//!
//! A page of another site can make a browser send requests to a server on the same machine under a host name
//! that the site resolves to this machine (DNS rebinding); the browser would then treat it as a page of this
//! server. So a server that is bound to a loopback address only answers requests for loopback host names.

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
use std::net::IpAddr;
use tower_http::cors::{Any, CorsLayer};
use tower_http::set_header::SetResponseHeaderLayer;

/// Allows our own scripts, wasm, and workers made from them; nothing from other origins.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval' blob:; \
                      worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; \
                      font-src 'self' data:; connect-src 'self' data: blob:; object-src 'none'; \
                      base-uri 'none'; form-action 'none'; \
                      frame-ancestors 'self'";

/// Wraps the routes in all checks and headers.
pub(super) fn guarded(router: Router, is_local: bool, allows_other_sites: bool) -> Router {
    let header = |name: HeaderName, value: &'static str| {
        SetResponseHeaderLayer::overriding(name, HeaderValue::from_static(value))
    };
    let sharing = if allows_other_sites { "cross-origin" } else { "same-origin" };
    let router = if allows_other_sites { router.layer(cross_site()) } else { router };
    router
        .layer(from_fn_with_state(is_local, check_host))
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

async fn check_host(State(is_local): State<bool>, request: Request, next: Next) -> Response {
    let mut hosts = request.headers().get_all(HOST).iter();
    let (host, others) = (hosts.next(), hosts.count());
    let Some(host) = host.and_then(|host| host.to_str().ok()).filter(|_| others == 0) else {
        return (
            StatusCode::BAD_REQUEST,
            "exactly one Host header is required
",
        )
            .into_response();
    };
    let target = request.uri().authority().map_or(host, Authority::as_str);
    if is_local && !(is_this_machine(host) && is_this_machine(target)) {
        let text = "this server only answers requests for localhost; start it with --host to allow others
";
        return (StatusCode::MISDIRECTED_REQUEST, text).into_response();
    }
    next.run(request).await
}

/// Whether an authority (a host with or without a port) is a loopback name or address, which no other
/// site can use.
fn is_this_machine(authority: &str) -> bool {
    let Ok(authority) = authority.parse::<Authority>() else { return false };
    let host = authority.host();
    let bare = host.strip_prefix('[').and_then(|host| host.strip_suffix(']')).unwrap_or(host);
    let has_user = authority.as_str().contains('@');
    !has_user
        && (host.eq_ignore_ascii_case("localhost") || bare.parse::<IpAddr>().is_ok_and(|ip| ip.is_loopback()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_loopback_names_are_this_machine() {
        for good in ["localhost", "LOCALHOST:7878", "127.0.0.1", "127.0.0.1:1", "[::1]", "[::1]:7878"] {
            assert!(is_this_machine(good), "{good}");
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
            assert!(!is_this_machine(bad), "{bad}");
        }
    }
}
