//! `mavc view`: a page that renews itself. The spec is read again whenever a file that it names changes; the plan that
//! is running is then cancelled. Browsers on this computer get the page and what has changed.

mod board;
mod planning;
mod request;
mod server;

use super::watched::Watched;
use crate::cancel::Cancel;
use crate::spec::Compiled;
use board::Board;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;

/// The page of one spec, at an address of this computer.
pub struct View {
    listener: TcpListener,
    port: u16,
    watched: Watched,
}

impl View {
    /// Listens at a port of 127.0.0.1; 0 stands for any that is free.
    ///
    /// # Errors
    /// The port is taken or may not be used, or files cannot be watched.
    pub fn new(port: u16) -> Result<Self, String> {
        let refused = |e: std::io::Error| format!("cannot listen at port {port}: {}", crate::input::reason(&e));
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(refused)?;
        let port = listener.local_addr().map_err(refused)?.port();
        Ok(View { listener, port, watched: Watched::new()? })
    }

    /// Where the page is.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/", self.port)
    }

    /// Shows the spec `name` until the process ends. `read` compiles it from its files; its error is that of a file
    /// which cannot be read, for people.
    ///
    /// # Errors
    /// Files cannot be watched, or there are no threads.
    pub fn show(mut self, name: &str, read: impl Fn() -> Result<Compiled, String>) -> Result<u8, String> {
        let no_thread = |e: std::io::Error| format!("cannot start a thread: {e}");
        self.watched.add(&[name.to_string()])?;
        let board = Arc::new(Board::new(name));
        let (port, shown) = (self.port, board.clone());
        let serve = move || server::serve(&self.listener, port, &shown);
        std::thread::Builder::new().name("server".into()).spawn(serve).map_err(no_thread)?;
        loop {
            let cancel = Cancel::new();
            let run = match read() {
                Ok(compiled) => {
                    self.watched.add(&compiled.files.names())?;
                    let (board, cancel) = (board.clone(), cancel.clone());
                    let plan = move || planning::look(compiled, &board, &cancel);
                    Some(std::thread::Builder::new().name("plan".into()).spawn(plan).map_err(no_thread)?)
                }
                Err(problem) => {
                    board.refuse(problem);
                    None
                }
            };
            self.watched.wait()?;
            cancel.cancel();
            // A run that panicked has said so.
            let _ = run.map(std::thread::JoinHandle::join);
        }
    }
}
