//! Implementation of `FieldScene` for an emitted module, from its descriptions and the modules of
//! its fields.

/// Implements [`FieldScene`](crate::field::FieldScene) by the modules of the fields, whose
/// functions have the names of its methods.
///
/// ```text
/// field_scene! {
///     Machine: jacobian_reads_forces false;
///     0 module: linear true, local true, forces [Zero, Varying],
///         derivatives [Zero, Zero, Zero, Zero, Zero, Constant, Zero, Zero],
///         scale [1.0, 100.0], fixed [false, false], length 1.75, elements 24, order 4;
///     value "unit", "spec.name", "meaning";
///     rate "unit", "spec.name", "meaning";
///     slope "unit", "spec.name", "meaning";
///     at 0.0 => Start, coordinate Some(0), handed 13;
/// }
/// ```
///
/// with a row `at` for each attachment.
#[macro_export]
macro_rules! field_scene {
    (
        $machine:ident: jacobian_reads_forces $reads_forces:literal;
        $(
            $number:literal $module:ident: linear $linear:literal, local $local:tt,
                forces [$($force:ident),*], derivatives [$($derivative:ident),*],
                scale $scale:expr, fixed $fixed:expr, length $length:expr,
                elements $elements:literal, order $order:literal;
            value $value_unit:literal, $value:literal, $value_doc:literal;
            rate $rate_unit:literal, $rate:literal, $rate_doc:literal;
            slope $slope_unit:literal, $slope:literal, $slope_doc:literal;
            $(at $at:expr => $place:ident, coordinate $coordinate:expr, handed $handed:literal;)*
        )*
    ) => {
        impl<R: $crate::Real> $crate::field::FieldScene<R> for $machine {
            fn fields(&self) -> usize {
                [$($number),*].len()
            }
            fn field(&self, index: usize) -> $crate::field::FieldDescription<'_> {
                match index {
                    $($number => $crate::field::FieldDescription {
                        value: $crate::Quantity {
                            name: $value,
                            unit: $value_unit,
                            doc: $value_doc,
                        },
                        rate: $crate::Quantity { name: $rate, unit: $rate_unit, doc: $rate_doc },
                        slope: $crate::Quantity {
                            name: $slope,
                            unit: $slope_unit,
                            doc: $slope_doc,
                        },
                        scale: $scale,
                        fixed: $fixed,
                        length: $length,
                        attachments: &[$($crate::field::FieldAttachment {
                            coordinate: $coordinate,
                            place: $crate::field::FieldPlace::$place,
                            at: $at,
                            handed: $handed,
                        }),*],
                        parameters: &$module::PARAMETERS,
                        elements: $elements,
                        order: $order,
                    },)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_inertia(&self, index: usize, x: R, parameters: &[R]) -> R {
                let p = Parameters::from_slice(parameters);
                let [inertia] = match index {
                    $($number => $module::inertia(x, &p),)*
                    _ => $crate::field::no_field(index),
                };
                inertia
            }
            fn field_initial(&self, index: usize, x: R, parameters: &[R]) -> [R; 2] {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $module::initial(x, &p),)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_force(
                &self,
                index: usize,
                time: R,
                x: R,
                point: &$crate::field::FieldPoint<R>,
                parameters: &[R],
            ) -> [R; 2] {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $module::force(time, x, point, &p),)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_force_jacobian(
                &self,
                index: usize,
                time: R,
                x: R,
                point: &$crate::field::FieldPoint<R>,
                parameters: &[R],
            ) -> [R; 8] {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $module::force_jacobian(time, x, point, &p),)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_energy(
                &self,
                index: usize,
                time: R,
                x: R,
                point: &$crate::field::FieldPoint<R>,
                parameters: &[R],
            ) -> [R; 2] {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $module::energy(time, x, point, &p),)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_power(
                &self,
                index: usize,
                time: R,
                x: R,
                point: &$crate::field::FieldPoint<R>,
                parameters: &[R],
            ) -> [R; 3] {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $module::power(time, x, point, &p),)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_inertia_gradient(
                &self,
                index: usize,
                x: R,
                parameters: &[R],
                values: &mut [R],
            ) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => values.copy_from_slice(&$module::inertia_gradient(x, &p)),)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_force_gradient(
                &self,
                index: usize,
                time: R,
                x: R,
                point: &$crate::field::FieldPoint<R>,
                parameters: &[R],
                values: &mut [R],
            ) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => {
                        values.copy_from_slice(&$module::force_gradient(time, x, point, &p));
                    })*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_places(&self, index: usize, parameters: &[R], values: &mut [R]) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => values.copy_from_slice(&$module::places(&p)),)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_places_gradient(&self, index: usize, parameters: &[R], values: &mut [R]) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => values.copy_from_slice(&$module::places_gradient(&p)),)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn jacobian_reads_forces(&self) -> bool {
                $reads_forces
            }
            fn force_structure(&self, index: usize) -> $crate::field::ForceStructure {
                match index {
                    $($number => $crate::field::ForceStructure {
                        linear: $linear,
                        local: $local,
                        forces: [$($crate::field::Variation::$force),*],
                        derivatives: [$($crate::field::Variation::$derivative),*],
                    },)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_inertias(&self, index: usize, x: &[R], parameters: &[R], inertias: &mut [R]) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => {
                        for (inertia, x) in inertias.iter_mut().zip(x) {
                            [*inertia] = $module::inertia(*x, &p);
                        }
                    })*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_forces_on_values(
                &self,
                index: usize,
                time: R,
                [x, u, u_t]: [&[R]; 3],
                parameters: &[R],
                forces: &mut [R],
            ) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $crate::__if_local! {
                        $local index $module::on_value(time, x, u, u_t, &p, forces)
                    },)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_forces_on_values_jacobian(
                &self,
                index: usize,
                time: R,
                [x, u, u_t]: [&[R]; 3],
                parameters: &[R],
                [by_u, by_u_t]: [&mut [R]; 2],
            ) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $crate::__if_local! {
                        $local index $module::on_value_jacobian(time, x, u, u_t, &p, by_u, by_u_t)
                    },)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_forces_on_values_by_time(
                &self,
                index: usize,
                time: R,
                [x, u, u_t]: [&[R]; 3],
                parameters: &[R],
                (_, by_time): (&mut [R], &mut [R]),
            ) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $crate::__if_local! {
                        $local index $module::on_value_by_time(time, x, u, u_t, &p, by_time)
                    },)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_forces_on_slopes(
                &self,
                index: usize,
                [u_x, u_xt]: [&[R]; 2],
                parameters: &[R],
                forces: &mut [R],
            ) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $crate::__if_local! {
                        $local index $module::on_slope(u_x, u_xt, &p, forces)
                    },)*
                    _ => $crate::field::no_field(index),
                }
            }
            fn field_forces_on_slopes_jacobian(
                &self,
                index: usize,
                [u_x, u_xt]: [&[R]; 2],
                parameters: &[R],
                [by_u_x, by_u_xt]: [&mut [R]; 2],
            ) {
                let p = Parameters::from_slice(parameters);
                match index {
                    $($number => $crate::__if_local! {
                        $local index $module::on_slope_jacobian(u_x, u_xt, &p, by_u_x, by_u_xt)
                    },)*
                    _ => $crate::field::no_field(index),
                }
            }
        }
    };
}

/// Selects the functions for many points, which exist for local forces only.
#[doc(hidden)]
#[macro_export]
macro_rules! __if_local {
    (true $index:ident $($call:tt)*) => {
        $($call)*
    };
    (false $index:ident $($call:tt)*) => {
        $crate::field::no_field($index)
    };
}
