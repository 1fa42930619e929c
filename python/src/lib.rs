//! The native part of the Python package `mavc`, module `mavc._mavc`. It passes texts, numbers and handles; what people
//! use is written in Python, beside this folder.
//!
//! Without the macros of PyO3: their features of `syn` would make cargo compile `serde_derive` and everything that
//! depends on it, mavc too, a second time (two minutes). So functions are closures, and handles are capsules.

mod builder;
mod campaign;
mod columns;
mod compile;
mod export;
mod held;
mod import;
mod job;
mod logs;
mod plan;
mod simulate;
mod tasks;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyCFunction, PyDict, PyTuple};
use pyo3::{IntoPyObject, IntoPyObjectExt, ffi};
use std::ffi::CStr;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The arguments of a call, by position.
type Arguments<'a, 'py> = &'a Bound<'py, PyTuple>;

/// A value that Python takes.
type Value = PyResult<Py<PyAny>>;

/// What a function of the module does.
type Function = fn(Arguments) -> Value;

/// The functions of the module.
const FUNCTIONS: [(&CStr, Function); 29] = [
    (c"compile", compile::compile),
    (c"facts", compile::facts),
    (c"format", compile::format),
    (c"templates", compile::templates),
    (c"import_vehicle", import::vehicle),
    (c"import_mission", import::mission),
    (c"diagnose", logs::diagnose),
    (c"identify", logs::identify),
    (c"build", builder::build),
    (c"unit", builder::unit),
    (c"is_text", builder::is_text),
    (c"dimension", builder::dimension),
    (c"check", tasks::check),
    (c"analyze", tasks::analyze),
    (c"compare", tasks::compare),
    (c"verify", tasks::verify),
    (c"panic", tasks::panic),
    (c"plan", plan::plan),
    (c"certificate", plan::certificate),
    (c"page", plan::page),
    (c"branches", plan::branches),
    (c"table", plan::table),
    (c"export", export::plan),
    (c"bag_files", export::bag_files),
    (c"simulate", simulate::simulate),
    (c"export_log", export::log),
    (c"layout", export::layout),
    (c"campaign", campaign::campaign),
    (c"columns", columns::columns),
];

/// What the interpreter knows of the module from the start: its name.
static mut DEFINITION: ffi::PyModuleDef = ffi::PyModuleDef {
    m_base: ffi::PyModuleDef_HEAD_INIT,
    m_name: c"_mavc".as_ptr(),
    m_doc: c"The native part of mavc.".as_ptr(),
    m_size: -1,
    m_methods: std::ptr::null_mut(),
    m_slots: std::ptr::null_mut(),
    m_traverse: None,
    m_clear: None,
    m_free: None,
};

fn module(py: Python) -> PyResult<Bound<PyModule>> {
    // SAFETY: the definition lives forever, only the interpreter changes it, and it imports a module once at a time.
    let module = unsafe { Bound::from_owned_ptr_or_err(py, ffi::PyModule_Create(&raw mut DEFINITION)) }?;
    let module = module.cast_into::<PyModule>()?;
    for (name, function) in FUNCTIONS {
        let call = move |arguments: &Bound<PyTuple>, _: Option<&Bound<PyDict>>| caught(|| function(arguments));
        module.add(name.to_str().unwrap_or_default(), PyCFunction::new_closure(py, Some(name), None, call)?)?;
    }
    let new = |_: &Bound<PyTuple>, _: Option<&Bound<PyDict>>| caught(job::new_cancel);
    module.add("new_cancel", PyCFunction::new_closure(py, Some(c"new_cancel"), None, new)?)?;
    let cancel = |arguments: &Bound<PyTuple>, _: Option<&Bound<PyDict>>| caught(|| job::cancel(arguments));
    module.add("cancel", PyCFunction::new_closure(py, Some(c"cancel"), None, cancel)?)?;
    module.add("VERSION", env!("CARGO_PKG_VERSION"))?;
    Ok(module)
}

/// A panic as an exception that `except Exception` catches; PyO3's own is one that only few programs catch.
fn caught(work: impl FnOnce() -> Value) -> Value {
    // A panic leaves nothing half changed: values behind handles never change.
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|payload| Err(job::internal(&*payload)))
}

/// Any value as an object.
fn object<'py, T: IntoPyObject<'py>>(py: Python<'py>, value: T) -> Value {
    value.into_py_any(py)
}

/// Why something cannot be made, as an exception.
fn error(why: String) -> PyErr {
    PyValueError::new_err(why)
}

/// Makes the module.
///
/// # Safety
/// Only the interpreter calls it, attached to the calling thread.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn PyInit__mavc() -> *mut ffi::PyObject {
    // SAFETY: see above.
    let py = unsafe { Python::assume_attached() };
    match catch_unwind(|| module(py)) {
        Ok(Ok(module)) => module.into_ptr(),
        Ok(Err(error)) => {
            error.restore(py);
            std::ptr::null_mut()
        }
        Err(payload) => {
            job::internal(&*payload).restore(py);
            std::ptr::null_mut()
        }
    }
}
