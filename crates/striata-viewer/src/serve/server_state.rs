//! Shared state of the server.

use std::sync::Arc;

use axum::extract::FromRef;

use super::assets::Assets;
use super::folder::Folder;
use super::listing::Listing;
use super::session::Session;
use super::thumbnails::Thumbnails;

/// State of the server; each request handler accesses the part that it needs.
#[derive(Clone, Debug)]
pub(super) struct ServerState {
    pub folder: Arc<Folder>,
    pub listing: Arc<Listing>,
    pub thumbnails: Arc<Thumbnails>,
    pub assets: Arc<Assets>,
    /// The pages that keep the server alive, if any do.
    pub session: Option<Arc<Session>>,
}

impl FromRef<ServerState> for Arc<Folder> {
    fn from_ref(state: &ServerState) -> Self {
        state.folder.clone()
    }
}

impl FromRef<ServerState> for Arc<Listing> {
    fn from_ref(state: &ServerState) -> Self {
        state.listing.clone()
    }
}

impl FromRef<ServerState> for Arc<Thumbnails> {
    fn from_ref(state: &ServerState) -> Self {
        state.thumbnails.clone()
    }
}

impl FromRef<ServerState> for Arc<Assets> {
    fn from_ref(state: &ServerState) -> Self {
        state.assets.clone()
    }
}

impl FromRef<ServerState> for Option<Arc<Session>> {
    fn from_ref(state: &ServerState) -> Self {
        state.session.clone()
    }
}
