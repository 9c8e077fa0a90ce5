//! Address of what the debugger shows, and the command that opens it there.

use super::Model;
use crate::scene::view_command;
use crate::trace::Address;
use crate::trace::address::{AddressPart, path_of};
use crate::trace::facts::TreePath;

impl Model {
    /// The address of what is shown.
    pub fn address(&self) -> Address {
        let mut address = Address {
            scene: None,
            pixel: self.picture.cursor,
            path: TreePath::default(),
            part: None,
        };
        if let Some(session) = &self.session {
            address.pixel = (session.trace.x, session.trace.y);
            let node = session.node();
            address.path = node.map_or_else(TreePath::default, |n| path_of(session.view(), n));
            address.part = Some(AddressPart::Event(session.cursor().position()));
        }
        address
    }

    /// The command that opens the debugger at what is shown.
    pub fn open_command(&self) -> String {
        let address = self.address().to_string();
        view_command(
            &self.options.scene,
            &self.world.scene,
            &self.settings,
            &address,
        )
    }
}
