//! The records of a ZIP archive whose entries are stored as they are.
//!
//! In a wide archive (ZIP64) each size and offset takes 64 bits, in a narrow one 32; one flag decides it for the whole
//! archive when it is begun, as its records can't change in length once data lies between them.

use super::little_endian::{append_u16, append_u32, append_u64};

/// How many bytes a local header takes, its padding included.
pub(super) const LOCAL_HEADER: usize = 128;

const LOCAL_SIGNATURE: u32 = 0x0403_4b50;
const CENTRAL_SIGNATURE: u32 = 0x0201_4b50;
const END_SIGNATURE: u32 = 0x0605_4b50;
const WIDE_END_SIGNATURE: u32 = 0x0606_4b50;
const WIDE_LOCATOR_SIGNATURE: u32 = 0x0706_4b50;
const WIDE_FIELD: u16 = 0x0001;
/// The extra field that other writers too align an entry's data with.
const PADDING_FIELD: u16 = 0xd935;
/// What a 32-bit field says when the number is in a 64-bit one.
const SEE_WIDE: u32 = u32::MAX;
/// 1 January 1980, the earliest that can be said: the same run makes the same file, whenever it is made.
const DATE: u16 = 0x0021;

/// One entry as it stands.
pub(super) struct Entry {
    pub(super) name: &'static str,
    /// Of its local header, from the start of the file.
    pub(super) offset: u64,
    /// Bytes
    pub(super) size: u64,
    /// CRC-32
    pub(super) checksum: u32,
}

impl Entry {
    /// Appends the record in front of the entry's data.
    pub(super) fn append_local_header(&self, wide: bool, bytes: &mut Vec<u8>) {
        let start = bytes.len();
        append_u32(bytes, LOCAL_SIGNATURE);
        self.append_common(wide, bytes);
        let name_end = bytes.len() - start + 2 + self.name.len();
        append_u16(bytes, (LOCAL_HEADER - name_end) as u16);
        bytes.extend_from_slice(self.name.as_bytes());
        if wide {
            append_u16(bytes, WIDE_FIELD);
            append_u16(bytes, 16);
            append_u64(bytes, self.size);
            append_u64(bytes, self.size);
        }
        let padding_end = bytes.len() - start + 4;
        append_u16(bytes, PADDING_FIELD);
        append_u16(bytes, (LOCAL_HEADER - padding_end) as u16);
        append_u16(bytes, 64);
        bytes.resize(start + LOCAL_HEADER, 0);
    }

    fn append_central_header(&self, wide: bool, bytes: &mut Vec<u8>) {
        append_u32(bytes, CENTRAL_SIGNATURE);
        append_u16(bytes, version(wide));
        self.append_common(wide, bytes);
        append_u16(bytes, if wide { 28 } else { 0 });
        // No comment, on the first disk, binary, no attributes.
        bytes.resize(bytes.len() + 10, 0);
        append_u32(bytes, narrow(self.offset, wide));
        bytes.extend_from_slice(self.name.as_bytes());
        if wide {
            append_u16(bytes, WIDE_FIELD);
            append_u16(bytes, 24);
            append_u64(bytes, self.size);
            append_u64(bytes, self.size);
            append_u64(bytes, self.offset);
        }
    }

    /// What local and central headers have in common: from the version to the length of the name.
    fn append_common(&self, wide: bool, bytes: &mut Vec<u8>) {
        append_u16(bytes, version(wide));
        // No flags, not compressed, at midnight.
        bytes.resize(bytes.len() + 6, 0);
        append_u16(bytes, DATE);
        append_u32(bytes, self.checksum);
        append_u32(bytes, narrow(self.size, wide));
        append_u32(bytes, narrow(self.size, wide));
        append_u16(bytes, self.name.len() as u16);
    }
}

/// Appends what an archive ends with: its central directory and what points at it.
/// `offset` is where in the file this will be.
pub(super) fn append_directory(entries: &[Entry], offset: u64, wide: bool, bytes: &mut Vec<u8>) {
    let start = bytes.len();
    for entry in entries {
        entry.append_central_header(wide, bytes);
    }
    let size = (bytes.len() - start) as u64;
    let count = entries.len() as u16;
    if wide {
        append_u32(bytes, WIDE_END_SIGNATURE);
        // How many bytes of this record follow.
        append_u64(bytes, 44);
        append_u16(bytes, version(wide));
        append_u16(bytes, version(wide));
        append_u64(bytes, 0);
        append_u64(bytes, u64::from(count));
        append_u64(bytes, u64::from(count));
        append_u64(bytes, size);
        append_u64(bytes, offset);
        append_u32(bytes, WIDE_LOCATOR_SIGNATURE);
        append_u32(bytes, 0);
        append_u64(bytes, offset + size);
        append_u32(bytes, 1);
    }
    append_u32(bytes, END_SIGNATURE);
    append_u32(bytes, 0);
    append_u16(bytes, count);
    append_u16(bytes, count);
    append_u32(bytes, narrow(size, false));
    append_u32(bytes, narrow(offset, wide));
    append_u16(bytes, 0);
}

/// The version of the format that a reader must know: 4.5 for ZIP64.
fn version(wide: bool) -> u16 {
    if wide { 45 } else { 20 }
}

fn narrow(number: u64, wide: bool) -> u32 {
    if wide { SEE_WIDE } else { u32::try_from(number).unwrap_or(SEE_WIDE) }
}
