//! Layout of patterns: names of nodes, and places of the entries that elements and ports reach.

use machinist_contract::Real;

use super::chain::{Chain, columns_beside};
use super::local::Local;
use super::mesh::{Mesh, Owner};
use super::section::Section;
use super::{FieldSimulator, Law, NOWHERE, PortRow};

impl<R: Real> FieldSimulator<'_, R> {
    pub(super) fn name_nodes(&mut self) {
        for (index, mesh) in self.meshes.iter().enumerate() {
            let description = self.scene.get().field(index);
            for (node, owner) in mesh.owners.iter().enumerate() {
                if let Owner::Field(_) = owner {
                    self.names[0].push(format!("{}[{node}]", description.value.name));
                    self.names[1].push(format!("{}[{node}]", description.rate.name));
                    self.field_of.push(index as u32);
                }
            }
        }
    }

    /// Returns the rows of the machine's state that the force on a port affects.
    fn rows_of_port(&self, handed: u32) -> impl Iterator<Item = (usize, u32)> + '_ {
        let entries = self.machine_parameter_jacobian.iter().enumerate();
        entries
            .filter(move |(_, (_, column))| *column == handed + 1)
            .map(|(index, (row, _))| (index, *row))
    }

    pub(super) fn lay_out_rate_jacobian(&mut self) {
        let machine = self.scene().rate_jacobian_pattern().entries;
        let n = self.coordinates() as u32;
        let mut entries: Vec<(u32, u32)> = (0..n).map(|row| (row, row + n)).collect();
        let machine: Vec<(u32, u32)> = machine
            .iter()
            .map(|(row, column)| (self.entry(*row as usize), self.entry(*column as usize)))
            .collect();
        entries.extend(&machine);
        self.each_element_entry(|owner, column| match owner {
            Owner::Fixed => {}
            Owner::Field(own) => {
                entries.push((n + self.machine.coordinates as u32 + own, column));
            }
            Owner::Port { handed, .. } => {
                let rows = self.rows_of_port(handed);
                entries.extend(rows.map(|(_, row)| (self.entry(row as usize), column)));
            }
        });
        entries.sort_unstable();
        entries.dedup();
        let find = |entry: (u32, u32)| {
            entries.binary_search(&entry).map_or(u32::MAX, |index| index as u32)
        };
        self.machine_entries = machine.into_iter().map(find).collect();
        let laws = self.meshes.iter().enumerate();
        self.laws = laws.map(|(index, mesh)| self.law(index, mesh, &find)).collect();
        self.rate_jacobian = entries;
    }

    /// Chooses the way in which the elements of a field are evaluated.
    fn law(&self, index: usize, mesh: &Mesh, find: &dyn Fn((u32, u32)) -> u32) -> Law {
        let local = Local { field: index, structure: self.scene().force_structure(index) };
        let place = |row, column| find((row, column));
        let columns = |owner| self.columns(owner);
        if local.structure.local && Section::is_there(&local) {
            let rows = |owner| match owner {
                Owner::Port { handed, .. } => {
                    self.rows_of_port(handed).map(|(_, row)| self.entry(row as usize)).collect()
                }
                _ => Vec::new(),
            };
            let places = self.entries_of(mesh, find);
            Law::Section(Section::new(local, mesh, places, columns, rows, place))
        } else if local.structure.local && mesh.order == 1 {
            Law::Chain(Chain::new(local, mesh, columns, place))
        } else {
            Law::Any { places: self.entries_of(mesh, find) }
        }
    }

    /// Returns the places of the entries of every element, by u and by u'.
    fn entries_of(&self, mesh: &Mesh, find: &dyn Fn((u32, u32)) -> u32) -> Vec<[u32; 2]> {
        let first = (self.coordinates() + self.machine.coordinates) as u32;
        let mut places = Vec::new();
        for nodes in mesh.elements_of_nodes() {
            for row in nodes.clone() {
                for column in nodes.clone() {
                    let place = match (mesh.owners[row], self.columns(mesh.owners[column])) {
                        (Owner::Field(own), Some(columns)) => {
                            columns.map(|column| find((first + own, column)))
                        }
                        _ => [NOWHERE; 2],
                    };
                    places.push(place);
                }
            }
        }
        places
    }

    pub(super) fn lay_out_ports(&mut self) {
        let mut port_rows = Vec::new();
        for mesh in &self.meshes {
            for node in &mesh.ports {
                if let Owner::Port { handed, .. } = mesh.owners[*node] {
                    self.ports.push((mesh.first_node + node, handed as usize));
                }
            }
            port_rows.extend(mesh.ports.iter().map(|node| self.rows_reached(mesh, *node)));
        }
        self.port_rows = port_rows;
    }

    /// Returns the rows that the force on a port affects, with their places.
    fn rows_reached(&self, mesh: &Mesh, node: usize) -> Vec<PortRow> {
        let Owner::Port { handed, .. } = mesh.owners[node] else { return Vec::new() };
        let beside = columns_beside(mesh, node, |owner| self.columns(owner));
        let rows = self.rows_of_port(handed).map(|(by_force, row)| {
            let entry = self.entry(row as usize);
            let place = |column: u32| {
                let place = self.rate_jacobian.binary_search(&(entry, column));
                place.map_or(NOWHERE, |place| place as u32)
            };
            PortRow {
                row: entry,
                coordinate: row.saturating_sub(self.machine.positions as u32),
                by_force: by_force as u32,
                places: beside.map(place),
            }
        });
        rows.collect()
    }

    /// Calls `see` with the owner of the row and the column of each pair of nodes of an element if
    /// the force of one depends on the motion of the other.
    fn each_element_entry(&self, mut see: impl FnMut(Owner, u32)) {
        for (index, mesh) in self.meshes.iter().enumerate() {
            let structure = self.scene().force_structure(index);
            for nodes in mesh.elements_of_nodes() {
                for row in nodes.clone() {
                    for node in nodes.clone() {
                        let Some(columns) = self.columns(mesh.owners[node]) else { continue };
                        let reaches = structure.reaches(row == node);
                        let there = columns.into_iter().zip(reaches).filter(|(_, there)| *there);
                        there.for_each(|(column, _)| see(mesh.owners[row], column));
                    }
                }
            }
        }
    }

    pub(super) fn lay_out_others(&mut self) {
        let n = self.machine.coordinates as u32;
        let own = |index: usize| n + index as u32;
        let mut mass = self.scene().mass_matrix_pattern().entries.to_vec();
        mass.extend((0..self.own_nodes).map(|index| (own(index), own(index))));
        self.mass_matrix = mass;

        let mut entries: Vec<(u32, u32)> = Vec::new();
        for (row, column) in &self.machine_parameter_jacobian {
            if (*column as usize) < self.parameters {
                entries.push((self.entry(*row as usize), *column));
            }
        }
        for (index, mesh) in self.meshes.iter().enumerate() {
            let description = self.scene().field(index);
            for owner in &mesh.owners {
                match *owner {
                    Owner::Fixed => {}
                    Owner::Field(node) => {
                        let row = self.coordinates() as u32 + n + node;
                        entries.extend(description.parameters.iter().map(|p| (row, *p)));
                    }
                    Owner::Port { handed, .. } => {
                        let rows = self.machine_parameter_jacobian.iter();
                        for (row, _) in rows.filter(|(_, c)| [handed, handed + 1].contains(c)) {
                            let row = self.entry(*row as usize);
                            entries.extend(description.parameters.iter().map(|p| (row, *p)));
                        }
                    }
                }
            }
        }
        entries.sort_unstable();
        entries.dedup();
        self.parameter_jacobian = entries;
    }
}
