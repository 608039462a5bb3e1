//! Loops in the widest vectors that the processor has, whatever the program is compiled for.
//!
//! Sums and products are the same in vectors of any width, to the last bit, because nothing is
//! fused that is not fused elsewhere. Only loops with many of them gain, such as those of
//! sensitivities.

#![allow(unsafe_code, reason = "what is compiled for wider vectors is called where there are some")]

/// A loop. [`Work::run`] and everything it calls must be `#[inline(always)]`, or it is not compiled
/// for wider vectors.
pub(super) trait Work {
    /// The result.
    type Result;
    /// Runs the loop.
    fn run(self) -> Self::Result;
}

/// Runs a loop in the widest vectors.
pub(super) fn widest<W: Work>(work: W) -> W::Result {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has the features that the function is compiled for.
        return unsafe { with_avx2(work) };
    }
    work.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_avx2<W: Work>(work: W) -> W::Result {
    work.run()
}

#[cfg(test)]
mod tests {
    use super::{Work, widest};

    struct Sum<'a>(&'a [f64], &'a [f64]);

    impl Work for Sum<'_> {
        type Result = [f64; 5];
        #[inline(always)]
        fn run(self) -> [f64; 5] {
            let mut sums = [0.1; 5];
            for (row, factor) in self.0.as_chunks::<5>().0.iter().zip(self.1) {
                for (sum, value) in sums.iter_mut().zip(row) {
                    *sum += factor * value;
                }
            }
            sums
        }
    }

    #[test]
    fn wider_vectors_give_the_same_bits() {
        let mut random = fastrand::Rng::with_seed(7);
        let mut values = |count| (0..count).map(|_| random.f64() - 0.3).collect::<Vec<_>>();
        let (rows, factors) = (values(500), values(100));
        let wide = widest(Sum(&rows, &factors));
        assert_eq!(wide.map(f64::to_bits), Sum(&rows, &factors).run().map(f64::to_bits));
    }
}
