//! Paged files behind addresses: web servers and buckets.

use std::ops::Range;
use std::sync::Arc;

use object_store::path::Path;
use object_store::{ObjectStore, ObjectStoreExt, parse_url_opts};
use tokio::runtime::{Builder, Runtime};
use tokio::sync::Semaphore;
use url::Url;

use crate::{HEAD_NAME, PagedError, Store, StoredPlace, Want, image_path, page_path};

/// Number of simultaneous requests.
const MAX_REQUESTS: usize = 16;

/// A web server or a bucket, read in ranges.
pub(crate) struct RemoteStore {
    name: String,
    store: Arc<dyn ObjectStore>,
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
        Ok(Self { name: address.to_owned(), store: Arc::from(store), path, is_folder, runtime })
    }

    /// Whether the address has one object per page.
    #[cfg(feature = "build")]
    pub(crate) fn is_folder(&self) -> bool {
        self.is_folder
    }

    fn path_of(&self, place: StoredPlace) -> Result<Path, PagedError> {
        let path = match place {
            StoredPlace::Head if self.is_folder => Path::parse(format!("{}/{HEAD_NAME}", self.path)),
            StoredPlace::Head => Ok(self.path.clone()),
            StoredPlace::Page(id) => Path::parse(format!("{}/{}", self.path, page_path(id))),
            StoredPlace::Image(index) => Path::parse(format!("{}/{}", self.path, image_path(index))),
        };
        path.map_err(|error| self.failed(&error))
    }

    fn failed(&self, error: &dyn std::fmt::Display) -> PagedError {
        PagedError::Io { place: self.name.clone(), source: std::io::Error::other(error.to_string()) }
    }
}

impl Store for RemoteStore {
    fn name(&self) -> &str {
        &self.name
    }

    fn read(&self, place: StoredPlace, range: Range<u64>) -> Result<Vec<u8>, PagedError> {
        let path = self.path_of(place)?;
        let bytes = self.runtime.block_on(self.store.get_range(&path, range));
        Ok(bytes.map_err(|error| self.failed(&error))?.to_vec())
    }

    fn read_all(&self, wants: &[Want]) -> Result<Vec<Vec<u8>>, PagedError> {
        let permits = Arc::new(Semaphore::new(MAX_REQUESTS));
        let mut requests = Vec::with_capacity(wants.len());
        for want in wants {
            let (path, range) = (self.path_of(want.place)?, want.range.clone());
            let (store, permits) = (Arc::clone(&self.store), Arc::clone(&permits));
            requests.push(self.runtime.spawn(async move {
                // The semaphore is never closed.
                let _permit = permits.acquire().await;
                store.get_range(&path, range).await
            }));
        }
        let bytes = requests.into_iter().map(|request| {
            let bytes = self.runtime.block_on(request).map_err(|error| self.failed(&error))?;
            Ok(bytes.map_err(|error| self.failed(&error))?.to_vec())
        });
        bytes.collect()
    }
}

/// Writing, in `build`.
#[cfg(feature = "build")]
mod writing {
    use object_store::{ObjectStoreExt, WriteMultipart};
    use tokio::task::JoinSet;

    use super::{Arc, MAX_REQUESTS, PagedError, RemoteStore, StoredPlace};

    /// Bytes of one part of an upload; buckets refuse parts of less than 5 MiB.
    const PART_BYTES: usize = 8 << 20;

    /// An object that is written in parts and becomes visible as a whole.
    pub(crate) struct Upload<'a> {
        store: &'a RemoteStore,
        parts: WriteMultipart,
    }

    /// Number of objects that are written at the same time.
    pub(crate) struct Puts<'a> {
        store: &'a RemoteStore,
        requests: JoinSet<object_store::Result<object_store::PutResult>>,
    }

    impl RemoteStore {
        /// Refuses an address whose bucket does not exist. A server that refuses to list the bucket is accepted, because
        /// it may still allow writing.
        pub(crate) fn check_bucket(&self) -> Result<(), PagedError> {
            match self.runtime.block_on(self.store.list_with_delimiter(Some(&self.path))) {
                Err(error @ object_store::Error::NotFound { .. }) => Err(self.failed(&error)),
                _ => Ok(()),
            }
        }

        /// Starts writing the file.
        pub(crate) fn upload(&self) -> Result<Upload<'_>, PagedError> {
            let path = self.path_of(StoredPlace::Head)?;
            let upload = self.runtime.block_on(self.store.put_multipart(&path));
            let upload = upload.map_err(|error| self.failed(&error))?;
            // Parts are sent by tasks of the runtime.
            let _inside = self.runtime.enter();
            Ok(Upload { store: self, parts: WriteMultipart::new_with_chunk_size(upload, PART_BYTES) })
        }

        /// Starts writing objects.
        pub(crate) fn put_all(&self) -> Puts<'_> {
            Puts { store: self, requests: JoinSet::new() }
        }
    }

    impl Upload<'_> {
        /// Appends bytes.
        pub(crate) fn write(&mut self, bytes: &[u8]) -> Result<(), PagedError> {
            let _inside = self.store.runtime.enter();
            let has_room = self.store.runtime.block_on(self.parts.wait_for_capacity(MAX_REQUESTS));
            has_room.map_err(|error| self.store.failed(&error))?;
            self.parts.write(bytes);
            Ok(())
        }

        /// Deletes the parts that have been written, because incomplete uploads are charged.
        pub(crate) fn abort(self) {
            // The error that led here is the one to report.
            let _ = self.store.runtime.block_on(self.parts.abort());
        }

        /// Makes the object visible.
        pub(crate) fn finish(self) -> Result<(), PagedError> {
            let done = self.store.runtime.block_on(self.parts.finish());
            done.map(drop).map_err(|error| self.store.failed(&error))
        }
    }

    impl Puts<'_> {
        /// Writes an object.
        pub(crate) fn put(&mut self, place: StoredPlace, bytes: &[u8]) -> Result<(), PagedError> {
            while self.requests.len() >= MAX_REQUESTS {
                self.wait()?;
            }
            let path = self.store.path_of(place)?;
            let (store, bytes) = (Arc::clone(&self.store.store), bytes.to_vec());
            let request = async move { store.put(&path, bytes.into()).await };
            self.requests.spawn_on(request, self.store.runtime.handle());
            Ok(())
        }

        /// Waits until all objects are written.
        pub(crate) fn finish(mut self) -> Result<(), PagedError> {
            while !self.requests.is_empty() {
                self.wait()?;
            }
            Ok(())
        }

        fn wait(&mut self) -> Result<(), PagedError> {
            let failed = |error: &dyn std::fmt::Display| self.store.failed(error);
            match self.store.runtime.block_on(self.requests.join_next()) {
                Some(Ok(written)) => written.map(drop).map_err(|error| failed(&error)),
                Some(Err(error)) => Err(failed(&error)),
                None => Ok(()),
            }
        }
    }
}
