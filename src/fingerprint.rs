//! The fingerprint of a run and the checksum of a saved roadmap: 64-bit FNV-1a (Fowler, Noll and Vo), byte by byte,
//! little-endian.

/// A hash that bytes are added to.
#[derive(Debug, Clone, Copy)]
pub struct Fingerprint(u64);

/// The hash of no bytes.
impl Default for Fingerprint {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Fingerprint {
    /// Adds bytes.
    pub fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Adds a 64-bit integer.
    pub fn integer(&mut self, value: u64) {
        self.bytes(&value.to_le_bytes());
    }

    /// Adds the bits of every number.
    pub fn numbers(&mut self, values: &[f64]) {
        values.iter().for_each(|value| self.integer(value.to_bits()));
    }

    /// The hash of all that was added.
    pub fn value(self) -> u64 {
        self.0
    }
}
