//! What a server holds.

use std::sync::Arc;

use axum::extract::FromRef;

use super::assets::Assets;
use super::folder::Folder;
use super::listing::Listing;
use super::pictures::Pictures;

/// All that requests are answered from, each from its part.
#[derive(Clone, Debug)]
pub(super) struct Site {
    pub(super) folder: Arc<Folder>,
    pub(super) listing: Arc<Listing>,
    pub(super) pictures: Arc<Pictures>,
    pub(super) assets: Arc<Assets>,
}

impl FromRef<Site> for Arc<Folder> {
    fn from_ref(site: &Site) -> Self {
        site.folder.clone()
    }
}

impl FromRef<Site> for Arc<Listing> {
    fn from_ref(site: &Site) -> Self {
        site.listing.clone()
    }
}

impl FromRef<Site> for Arc<Pictures> {
    fn from_ref(site: &Site) -> Self {
        site.pictures.clone()
    }
}

impl FromRef<Site> for Arc<Assets> {
    fn from_ref(site: &Site) -> Self {
        site.assets.clone()
    }
}
