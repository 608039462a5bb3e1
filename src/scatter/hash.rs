//! Random numbers by hashing a counter: any number can be computed alone and in any order.

/// 2^64 over the golden ratio, odd.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Mixes 64 bits: Stafford's variant 13 of the finalizer of MurmurHash3, as in `SplitMix64`
/// (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014).
fn mix(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// Returns 64 random bits of a key of several parts.
pub(super) fn hash(key: &[u64]) -> u64 {
    key.iter().fold(mix(key.len() as u64), |state, part| {
        mix(state.wrapping_add(GOLDEN) ^ mix(part.wrapping_add(GOLDEN)))
    })
}

/// Converts random bits to a number between 0 and 1, never 0 or 1.
pub(super) fn unit(bits: u64) -> f64 {
    /// 2^-52.
    const STEP: f64 = f64::EPSILON;
    ((bits >> 12) as f64 + 0.5) * STEP
}

/// Returns a random number between 0 and 1 of a key, never 0 or 1.
pub(crate) fn random_unit(key: &[u64]) -> f64 {
    unit(hash(key))
}

/// Returns a random integer below `bound`, with the method of Lemire without its rejection: the
/// bias is below `bound`/2^64.
pub(super) fn below(bits: u64, bound: u64) -> u64 {
    ((u128::from(bits) * u128::from(bound)) >> 64) as u64
}
