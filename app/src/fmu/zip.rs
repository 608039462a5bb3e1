//! Archives in ZIP form (APPNOTE 6.3.10), deflated, without dates: the same files give the same
//! bytes.
//!
//! Written here because crates for ZIP bring other crates and features of shared ones, for which
//! everything below Symbolica would be built twice.

use std::io::{self, Write as _};

use flate2::write::DeflateEncoder;
use flate2::{Compression, Crc};

/// Signatures of headers.
const LOCAL: u32 = 0x0403_4b50;
const CENTRAL: u32 = 0x0201_4b50;
const END: u32 = 0x0605_4b50;
/// Version 2.0: folders, deflated files.
const VERSION: u16 = 20;
/// Flag of names in UTF-8.
const FLAGS: u16 = 1 << 11;
const DEFLATED: u16 = 8;
/// 1 January 1980, the earliest possible date.
const DATE: u16 = (1 << 5) | 1;

/// Creates an archive of files, each with name and content.
///
/// # Errors
/// If a file or the archive has 4 GiB or more, or a name 64 KiB or more.
pub fn archive(files: &[(&str, &[u8])]) -> io::Result<Vec<u8>> {
    let (mut archive, mut central) = (Vec::new(), Vec::new());
    for (name, bytes) in files {
        let start = size(archive.len())?;
        let mut encoder = DeflateEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(bytes)?;
        let deflated = encoder.finish()?;
        let header = Header {
            crc: crc(bytes),
            deflated: size(deflated.len())?,
            size: size(bytes.len())?,
            name: u16::try_from(name.len()).map_err(io::Error::other)?,
        };
        put(&mut archive, &LOCAL.to_le_bytes());
        header.write(&mut archive);
        put(&mut archive, name.as_bytes());
        put(&mut archive, &deflated);
        put(&mut central, &CENTRAL.to_le_bytes());
        put(&mut central, &VERSION.to_le_bytes());
        header.write(&mut central);
        // No comment, first disk, no attributes.
        put(&mut central, &[0; 10]);
        put(&mut central, &start.to_le_bytes());
        put(&mut central, name.as_bytes());
    }
    let count = u16::try_from(files.len()).map_err(io::Error::other)?;
    let (at, length) = (size(archive.len())?, size(central.len())?);
    put(&mut archive, &central);
    put(&mut archive, &END.to_le_bytes());
    // The first and only disk.
    put(&mut archive, &[0; 4]);
    put(&mut archive, &count.to_le_bytes());
    put(&mut archive, &count.to_le_bytes());
    put(&mut archive, &length.to_le_bytes());
    put(&mut archive, &at.to_le_bytes());
    // No comment.
    put(&mut archive, &[0; 2]);
    Ok(archive)
}

/// Fields that both headers of a file share.
struct Header {
    crc: u32,
    deflated: u32,
    size: u32,
    name: u16,
}

impl Header {
    fn write(&self, into: &mut Vec<u8>) {
        for field in [VERSION, FLAGS, DEFLATED, 0, DATE] {
            put(into, &field.to_le_bytes());
        }
        for field in [self.crc, self.deflated, self.size] {
            put(into, &field.to_le_bytes());
        }
        // No extra field.
        for field in [self.name, 0] {
            put(into, &field.to_le_bytes());
        }
    }
}

fn put(into: &mut Vec<u8>, bytes: &[u8]) {
    into.extend_from_slice(bytes);
}

fn size(length: usize) -> io::Result<u32> {
    u32::try_from(length).map_err(io::Error::other)
}

fn crc(bytes: &[u8]) -> u32 {
    let mut crc = Crc::new();
    crc.update(bytes);
    crc.sum()
}
