//! Whole numbers of any length, as little arithmetic as decimal numbers need.

use std::cmp::Ordering;

/// A whole number: its digits to the base 2^32, the lowest first, the highest not 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Big {
    digits: Vec<u32>,
}

impl Big {
    pub fn new(value: u64) -> Self {
        let mut big = Self { digits: vec![value as u32, (value >> 32) as u32] };
        big.trim();
        big
    }

    fn trim(&mut self) {
        while self.digits.last() == Some(&0) {
            self.digits.pop();
        }
    }

    /// How many bits the number has: 0 for 0.
    pub fn bits(&self) -> i32 {
        self.digits.last().map_or(0, |last| 32 * self.digits.len() as i32 - last.leading_zeros() as i32)
    }

    /// Makes it `factor` times itself and `more`.
    pub fn multiply(&mut self, factor: u32, more: u32) {
        let mut carry = u64::from(more);
        for digit in &mut self.digits {
            carry += u64::from(*digit) * u64::from(factor);
            *digit = carry as u32;
            carry >>= 32;
        }
        if carry > 0 {
            self.digits.push(carry as u32);
        }
    }

    /// Makes it 10^`exponent` times itself.
    pub fn scale(&mut self, exponent: u32) {
        for _ in 0..exponent / 9 {
            self.multiply(1_000_000_000, 0);
        }
        for _ in 0..exponent % 9 {
            self.multiply(10, 0);
        }
    }

    /// Makes it 2^`bits` times itself.
    pub fn shift(&mut self, bits: u32) {
        self.multiply(1 << (bits % 32), 0);
        if !self.digits.is_empty() {
            self.digits.splice(..0, (0..bits / 32).map(|_| 0));
        }
    }

    /// Adds another number.
    pub fn add(&mut self, other: &Big) {
        let mut carry = 0;
        for i in 0..self.digits.len().max(other.digits.len()) {
            if i == self.digits.len() {
                self.digits.push(0);
            }
            carry += u64::from(self.digits[i]) + u64::from(*other.digits.get(i).unwrap_or(&0));
            self.digits[i] = carry as u32;
            carry >>= 32;
        }
        if carry > 0 {
            self.digits.push(carry as u32);
        }
    }

    /// Takes away a number that is not larger.
    pub fn subtract(&mut self, other: &Big) {
        let mut borrow = 0;
        for (i, digit) in self.digits.iter_mut().enumerate() {
            borrow += i64::from(*digit) - i64::from(*other.digits.get(i).unwrap_or(&0));
            *digit = borrow as u32;
            borrow >>= 32;
        }
        self.trim();
    }

    pub fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }

    pub fn compare(&self, other: &Big) -> Ordering {
        let by_length = self.digits.len().cmp(&other.digits.len());
        by_length.then_with(|| self.digits.iter().rev().cmp(other.digits.iter().rev()))
    }
}
