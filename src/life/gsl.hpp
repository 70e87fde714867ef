// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>

namespace spricka::life {

/// GSL ends the program at a mistake unless told otherwise: here its return values are looked at.
inline void disable_gsl_error_handler() {
  [[maybe_unused]] static gsl_error_handler_t* const before = gsl_set_error_handler_off();
}

/// A callable as GSL takes functions; it must outlive this.
template <class F> class GslFunction {
public:
  explicit GslFunction(const F& f)
      : function_{[](double x, void* p) { return (*static_cast<const F*>(p))(x); },
                  const_cast<F*>(&f)} {}
  [[nodiscard]] const gsl_function* get() const { return &function_; }

private:
  gsl_function function_;
};

/// Gives an object of GSL back by its own function, for std::unique_ptr.
template <auto free_object> struct GslDeleter {
  template <class Object> void operator()(Object* object) const { free_object(object); }
};

} // namespace spricka::life
