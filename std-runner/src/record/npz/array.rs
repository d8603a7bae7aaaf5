//! One array of the archive: its place in the file and what is in it so far.

use std::io::{self, Seek, SeekFrom, Write};

use super::npy::{self, Header};
use super::zip::{Entry, LOCAL_HEADER};
use crate::record::Element;

/// How many bytes stand in front of an array's rows. An array begins at a multiple of this, so they lie in one sector.
const FRONT: u64 = (LOCAL_HEADER + npy::HEADER) as u64;
/// How many numbers are turned into bytes, summed and written at a time: few enough to stay in a core's cache.
const NUMBERS_AT_A_TIME: usize = 1 << 14;

/// How much of an array is written, and its checksum.
#[derive(Clone, Default)]
pub(super) struct Progress {
    rows: u64,
    checksum: crc32fast::Hasher,
}

/// One array, of a fixed place and greatest size.
pub(super) struct Array {
    name: &'static str,
    header: Header,
    /// Where its local header is, bytes from the start of the file.
    offset: u64,
    /// Bytes
    row_size: u64,
}

impl Array {
    /// Reserves room for an array of up to `rows` rows of `R` at or behind `free`, the offset of the first free byte,
    /// which then moves behind it; `None` if no file can be that long.
    pub(super) fn reserve<R: Element>(
        name: &'static str,
        rows: u64,
        row_shape: &[u64],
        free: &mut u64,
    ) -> Option<Self> {
        let offset = free.checked_next_multiple_of(FRONT)?;
        let row_size = row_shape.iter().try_fold(R::SIZE, |size, &length| size.checked_mul(length))?;
        *free = rows.checked_mul(row_size)?.checked_add(offset)?.checked_add(FRONT)?;
        Some(Self { name, header: Header::new(R::NPY_TYPE, row_shape), offset, row_size })
    }

    /// Writes rows behind those of `progress`, where no reader looks yet.
    pub(super) fn write_rows<R: Element>(
        &self,
        rows: u64,
        numbers: &[R],
        progress: &mut Progress,
        file: &mut (impl Write + Seek),
        bytes: &mut Vec<u8>,
    ) -> io::Result<()> {
        file.seek(SeekFrom::Start(self.offset + FRONT + progress.rows * self.row_size))?;
        for some in numbers.chunks(NUMBERS_AT_A_TIME) {
            bytes.clear();
            R::append_bytes(some, bytes);
            progress.checksum.update(bytes);
            file.write_all(bytes)?;
        }
        progress.rows += rows;
        Ok(())
    }

    /// Writes, in one go, what stands in front of the rows.
    pub(super) fn write_front(
        &self,
        progress: &Progress,
        wide: bool,
        file: &mut (impl Write + Seek),
        bytes: &mut Vec<u8>,
    ) -> io::Result<()> {
        bytes.clear();
        self.entry(progress).append_local_header(wide, bytes);
        self.header.append(progress.rows, bytes);
        file.seek(SeekFrom::Start(self.offset))?;
        file.write_all(bytes)
    }

    /// What the archive's directory says of it.
    pub(super) fn entry(&self, progress: &Progress) -> Entry {
        Entry {
            name: self.name,
            offset: self.offset,
            size: npy::HEADER as u64 + progress.rows * self.row_size,
            // The header's own checksum is that of nothing.
            checksum: progress.checksum.clone().finalize(),
        }
    }
}
