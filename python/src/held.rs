//! Values behind handles: capsules that hold an `Arc`, told apart by their names.

use mavc::Spec;
use mavc::cancel::Cancel;
use mavc::diagnostic::Diagnostic;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyCapsuleMethods};
use std::ffi::CStr;
use std::sync::Arc;

/// A type that handles hold.
pub trait Held: Send + Sync + 'static {
    /// The name of its capsules; no other type has the same.
    const NAME: &'static CStr;

    fn into_handle(self, py: Python) -> PyResult<Py<PyAny>>
    where
        Self: Sized,
    {
        let capsule = PyCapsule::new_with_value(py, Arc::new(self), Self::NAME)?;
        Ok(capsule.into_any().unbind())
    }

    /// The value behind a handle.
    ///
    /// # Errors
    /// The object is not a handle of this type.
    fn of(handle: &Bound<PyAny>) -> PyResult<Arc<Self>>
    where
        Self: Sized,
    {
        let capsule = handle.cast::<PyCapsule>()?;
        let place = capsule.pointer_checked(Some(Self::NAME))?.cast::<Arc<Self>>();
        // SAFETY: only `into_handle` makes capsules of this name, with this type, and the handle keeps the value alive.
        Ok(Arc::clone(unsafe { place.as_ref() }))
    }
}

impl Held for Cancel {
    const NAME: &'static CStr = c"mavc.cancel";
}

/// A spec, with the warnings and advice that it was compiled with.
pub struct Compiled {
    pub spec: Spec,
    pub diagnostics: Vec<Diagnostic>,
}

impl Held for Compiled {
    const NAME: &'static CStr = c"mavc.spec";
}
