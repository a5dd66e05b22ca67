//! Methods of options that set one of them and keep the others.

/// Writes methods that set a field: `with_limit, limit: f64;`, or `with_limit, limit: some f64;` if the field
/// is an option that the method gives a value.
macro_rules! setters {
    ($with:ident, $field:ident: some $type:ty; $($rest:tt)*) => {
        #[doc = concat!("Sets [`Self::", stringify!($field), "`].")]
        pub fn $with(self, $field: $type) -> Self {
            Self { $field: Some($field), ..self }
        }
        $crate::setters::setters! { $($rest)* }
    };
    ($with:ident, $field:ident: $type:ty; $($rest:tt)*) => {
        #[doc = concat!("Sets [`Self::", stringify!($field), "`].")]
        pub fn $with(self, $field: $type) -> Self {
            Self { $field, ..self }
        }
        $crate::setters::setters! { $($rest)* }
    };
    () => {};
}

pub(crate) use setters;
