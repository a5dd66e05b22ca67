//! Open connections, and which of them give way to others.
//!
//! A client that opens connections and sends nothing must not keep others out. If there is no place for a new
//! connection, or its address has too many, the oldest one that has not sent a request for a while is closed.

use std::net::IpAddr;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use tokio::sync::Notify;

/// Time in which a new connection must not give way.
const FIRST_REQUEST: Duration = Duration::from_secs(1);

/// All open connections.
#[derive(Debug)]
pub(super) struct Connections {
    open: Mutex<Vec<Arc<Client>>>,
    /// Largest number of connections of one address, except those of this machine.
    most_per_address: usize,
}

/// One connection.
#[derive(Debug)]
pub(super) struct Client {
    address: IpAddr,
    since: Instant,
    has_request: AtomicBool,
    /// Notified when the connection must close.
    pub end: Notify,
}

impl Client {
    /// Notes that the client has sent a request.
    pub(super) fn has_asked(&self) {
        self.has_request.store(true, Ordering::Relaxed);
    }

    fn gives_way(&self) -> bool {
        !self.has_request.load(Ordering::Relaxed) && self.since.elapsed() >= FIRST_REQUEST
    }
}

impl Connections {
    pub(super) fn new(most_per_address: usize) -> Self {
        Self { open: Mutex::default(), most_per_address }
    }

    fn list(&self) -> MutexGuard<'_, Vec<Arc<Client>>> {
        self.open.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Closes the oldest connection that sends nothing, if there is one.
    pub(super) fn make_place(&self) {
        let mut open = self.list();
        if let Some(at) = open.iter().position(|client| client.gives_way()) {
            open.remove(at).end.notify_one();
        }
    }

    /// Adds a connection; [`None`] if its address has too many, all of which have sent requests.
    pub(super) fn add(&self, address: IpAddr) -> Option<Arc<Client>> {
        let mut open = self.list();
        let is_own = |client: &Arc<Client>| client.address == address;
        // A proxy on this machine stands for many clients.
        if !address.is_loopback()
            && open.iter().filter(|client| is_own(client)).count() >= self.most_per_address
        {
            let at = open.iter().position(|client| is_own(client) && client.gives_way())?;
            open.remove(at).end.notify_one();
        }
        let (since, has_request, end) = (Instant::now(), AtomicBool::new(false), Notify::new());
        let client = Arc::new(Client { address, since, has_request, end });
        open.push(Arc::clone(&client));
        Some(client)
    }

    /// Removes a connection that has ended.
    pub(super) fn remove(&self, client: &Arc<Client>) {
        self.list().retain(|other| !Arc::ptr_eq(other, client));
    }
}

#[cfg(test)]
mod tests {
    use std::net::Ipv4Addr;

    use super::*;

    /// Makes a client look old.
    fn aged(connections: &Connections, client: &Arc<Client>) -> Arc<Client> {
        let old = Arc::new(Client {
            address: client.address,
            since: client.since.checked_sub(2 * FIRST_REQUEST).unwrap(),
            has_request: AtomicBool::new(client.has_request.load(Ordering::Relaxed)),
            end: Notify::new(),
        });
        let mut open = connections.list();
        let at = open.iter().position(|other| Arc::ptr_eq(other, client)).unwrap();
        open[at] = Arc::clone(&old);
        old
    }

    #[test]
    fn silent_clients_give_way() {
        let connections = Connections::new(2);
        let address = IpAddr::V4(Ipv4Addr::new(192, 0, 2, 1));
        let busy = connections.add(address).unwrap();
        busy.has_asked();
        let busy = aged(&connections, &busy);
        let silent = connections.add(address).unwrap();
        assert!(connections.add(address).is_none(), "the address has two, and one is new");
        aged(&connections, &silent);
        let other = connections.add(address).unwrap();
        assert_eq!(connections.list().len(), 2, "the silent one is gone");
        connections.make_place();
        assert_eq!(connections.list().len(), 2, "one has sent a request, the other is new");
        aged(&connections, &other);
        connections.make_place();
        assert_eq!(connections.list().len(), 1);
        connections.remove(&busy);
        assert!(connections.list().is_empty());
        for _ in 0..9 {
            assert!(connections.add(IpAddr::V4(Ipv4Addr::LOCALHOST)).is_some(), "this machine has no limit");
        }
    }
}
