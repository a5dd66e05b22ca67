//! Paged files behind addresses: web servers and buckets.

use std::ops::Range;

use object_store::path::Path;
use object_store::{ObjectStore, ObjectStoreExt, parse_url_opts};
use tokio::runtime::{Builder, Runtime};
use url::Url;

use crate::{HEAD_NAME, PagedError, Place, Store, page_path};

/// A web server or a bucket, read in ranges.
pub(crate) struct RemoteStore {
    name: String,
    store: Box<dyn ObjectStore>,
    path: Path,
    /// Whether the address is a folder with one object per page.
    is_folder: bool,
    runtime: Runtime,
}

impl RemoteStore {
    /// Opens an address: a file if it ends in `.striata`, otherwise a folder. Keys of buckets come from the usual
    /// environment variables.
    pub(crate) fn open(address: &str) -> Result<Self, PagedError> {
        let failed = |source: std::io::Error| PagedError::Io { place: address.to_owned(), source };
        let other = |error: String| failed(std::io::Error::other(error));
        let url = Url::parse(address).map_err(|error| other(error.to_string()))?;
        let options: Vec<(String, String)> = std::env::vars()
            .filter(|(name, _)| ["AWS_", "AZURE_", "GOOGLE_"].iter().any(|prefix| name.starts_with(prefix)))
            .map(|(name, value)| (name.to_ascii_lowercase(), value))
            // Servers on the same machine have no certificates.
            .chain([("allow_http".to_owned(), "true".to_owned())])
            .collect();
        let (store, path) = parse_url_opts(&url, options).map_err(|error| other(error.to_string()))?;
        let runtime = Builder::new_multi_thread().worker_threads(1).enable_all().build().map_err(failed)?;
        let is_folder = !url.path().ends_with(".striata");
        Ok(Self { name: address.to_owned(), store, path, is_folder, runtime })
    }
}

impl Store for RemoteStore {
    fn name(&self) -> &str {
        &self.name
    }

    fn read(&self, place: Place, range: Range<u64>) -> Result<Vec<u8>, PagedError> {
        let path = match place {
            Place::Head if self.is_folder => Path::parse(format!("{}/{HEAD_NAME}", self.path)),
            Place::Head => Ok(self.path.clone()),
            Place::Page(id) => Path::parse(format!("{}/{}", self.path, page_path(id))),
        };
        let failed =
            |error: String| PagedError::Io { place: self.name.clone(), source: std::io::Error::other(error) };
        let path = path.map_err(|error| failed(error.to_string()))?;
        let bytes = self.runtime.block_on(self.store.get_range(&path, range));
        Ok(bytes.map_err(|error| failed(error.to_string()))?.to_vec())
    }
}
