// A function object of any type, as std::function is, but cheap to compile: hundreds of fields and columns have a type
// of function each, for which the browser's C++ library takes the compiler a minute.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace mixity {

template <class>
class LightFunction;

template <class Result, class... Arguments>
class LightFunction<Result(Arguments...)> {
 public:
  template <class Function>
  requires(!std::is_same_v<Function, LightFunction>) LightFunction(Function function)
      : held_(static_cast<const Holder*>(new Of<Function>(std::move(function)))) {}

  Result operator()(Arguments... arguments) const { return held_->call(arguments...); }

 private:
  struct Holder {
    Holder() = default;
    Holder(const Holder&) = delete;
    Holder& operator=(const Holder&) = delete;
    virtual ~Holder() = default;
    virtual Result call(Arguments... arguments) const = 0;
  };
  template <class Function>
  struct Of final : Holder {
    explicit Of(Function&& function) : function(std::move(function)) {}
    Result call(Arguments... arguments) const override { return function(arguments...); }
    Function function;
  };

  std::unique_ptr<const Holder> held_;
};

}  // namespace mixity
