// The engine as Python's module mixity._core: arrays in, results as JSON and arrays out. What is Pythonic about it
// stands in mixity/*.py.
#include "base/input_error.h"
#include "python/bindings.h"

NB_MODULE(_core, m) {
  m.doc() = "The engine of mixity.";
  nb::exception<mixity::InputError>(m, "InputError", PyExc_ValueError).doc() =
      "What mixity does not take, with the sentence that says why and what helps. A ValueError.";
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const mixity::Interrupted&) {
      if (!PyErr_Occurred()) PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
  mixity::bind_mechanics(m);
  mixity::bind_data(m);
  mixity::bind_fits(m);
  mixity::bind_studies(m);
  m.def("version", [] { return MIXITY_VERSION; });
}
