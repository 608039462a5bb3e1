//! XML documents with numbers.

use roxmltree::{Document, Node, ParsingOptions};

use super::tree::{LARGEST, RobotError};

/// Maximum number of XML nodes.
const MOST_NODES: u32 = 1_000_000;
/// Maximum nesting of bodies, defaults and frames.
pub(super) const DEEPEST: usize = 500;

/// Parses a document.
///
/// # Errors
/// If it is not XML, has a document type, and with it entities that expand without bound, or macros
/// of xacro.
pub fn parsed(text: &str) -> Result<Document<'_>, RobotError> {
    let options =
        ParsingOptions { allow_dtd: false, nodes_limit: MOST_NODES, ..Default::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let line = error.pos().row as usize;
        RobotError::new(line, format!("not valid XML: {error}"), "")
    })?;
    let xacro = |node: &Node<'_, '_>| {
        node.tag_name().namespace().is_some_and(|uri| uri.contains("xacro"))
            || node.attributes().any(|attribute| attribute.value().contains("${"))
    };
    let macros = document.root_element().descendants().filter(Node::is_element).find(xacro);
    if let Some(node) = macros {
        let help = "expand it first: xacro robot.urdf.xacro > robot.urdf";
        let reader = Reader { document: &document };
        return Err(reader.error(node, "the file contains macros of xacro", help));
    }
    Ok(document)
}

/// Reads numbers of a document.
pub struct Reader<'a, 'input> {
    /// The document.
    pub document: &'a Document<'input>,
}

pub type Read<T> = Result<T, RobotError>;

impl Reader<'_, '_> {
    pub fn line(&self, node: Node<'_, '_>) -> usize {
        self.document.text_pos_at(node.range().start).row as usize
    }

    pub fn error(
        &self,
        node: Node<'_, '_>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> RobotError {
        RobotError::new(self.line(node), message, help)
    }

    pub fn name(&self, node: Node<'_, '_>) -> Read<String> {
        let name = self.attribute(node, "name")?.trim().to_owned();
        if name.is_empty() || name.len() > 200 {
            let tag = node.tag_name().name();
            return Err(self.error(
                node,
                format!("the name of this <{tag}> is empty or too long"),
                "",
            ));
        }
        Ok(name)
    }

    pub fn attribute<'n>(&self, node: Node<'n, '_>, key: &str) -> Read<&'n str> {
        node.attribute(key).ok_or_else(|| {
            let tag = node.tag_name().name();
            self.error(node, format!("<{tag}> lacks the attribute `{key}`"), "")
        })
    }

    pub fn number_in(&self, node: Node<'_, '_>, key: &str, text: &str) -> Read<f64> {
        let value: Option<f64> = text.trim().parse().ok();
        match value {
            Some(value) if value.is_finite() && value.abs() <= LARGEST => Ok(value),
            Some(_) => {
                let message = format!("`{key}` is {}, which no robot has", text.escape_debug());
                let help = format!("numbers are finite and at most {LARGEST:e}, in SI units");
                Err(self.error(node, message, help))
            }
            None => {
                let message = format!("`{key}` is `{}`, not a number", text.escape_debug());
                Err(self.error(node, message, "numbers are in SI units and have no unit"))
            }
        }
    }

    pub fn number(&self, node: Node<'_, '_>, key: &str) -> Read<f64> {
        self.number_in(node, key, self.attribute(node, key)?)
    }

    pub fn number_or(&self, node: Option<Node<'_, '_>>, key: &str, default: f64) -> Read<f64> {
        match node.and_then(|node| Some((node, node.attribute(key)?))) {
            Some((node, text)) => self.number_in(node, key, text),
            None => Ok(default),
        }
    }

    pub fn vector(
        &self,
        node: Option<Node<'_, '_>>,
        key: &str,
        default: [f64; 3],
    ) -> Read<[f64; 3]> {
        let Some((node, text)) = node.and_then(|node| Some((node, node.attribute(key)?))) else {
            return Ok(default);
        };
        let parts: Vec<&str> = text.split_whitespace().collect();
        let [x, y, z] = parts[..] else {
            let message = format!("`{key}` has three numbers, not {}", parts.len());
            return Err(self.error(node, message, ""));
        };
        let mut values = [0.0; 3];
        for (value, part) in values.iter_mut().zip([x, y, z]) {
            *value = self.number_in(node, key, part)?;
        }
        Ok(values)
    }

    /// Reads numbers separated by spaces; `None` if there is no such attribute.
    pub fn numbers(&self, node: Node<'_, '_>, key: &str) -> Read<Option<Vec<f64>>> {
        let Some(text) = node.attribute(key) else { return Ok(None) };
        let all = text.split_whitespace().map(|part| self.number_in(node, key, part));
        all.collect::<Read<Vec<f64>>>().map(Some)
    }

    /// Reads exactly N numbers.
    pub fn exactly<const N: usize>(&self, node: Node<'_, '_>, key: &str) -> Read<Option<[f64; N]>> {
        let Some(all) = self.numbers(node, key)? else { return Ok(None) };
        let count = all.len();
        let all = all
            .try_into()
            .map_err(|_| self.error(node, format!("`{key}` has {N} numbers, not {count}"), ""))?;
        Ok(Some(all))
    }
}

/// Returns the first element of a name within another.
pub fn child<'a, 'input>(node: Node<'a, 'input>, tag: &str) -> Option<Node<'a, 'input>> {
    node.children().find(|child| child.is_element() && child.tag_name().name() == tag)
}
