// How the world's failures travel between rooms: a value or an Error, never an exception, never a printed line.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace rasterdiff {

enum class ErrorCode {
  BadInput,     ///< a scene, mesh, option or index that cannot be used (exit status 2)
  Io,           ///< a file that cannot be read or written (exit status 2)
  NoDevice,     ///< no loader, no driver, or every candidate refused (exit status 3)
  NotOffered,   ///< the device lacks what the scene needs: the scene is Skipped with this reason
  DeviceLost,   ///< the driver failed a call it has to carry out (exit status 4)
  TimedOut,     ///< a submit did not finish in time (exit status 4)
};

/// `where` is `file:line:col`, an option or a device; `what` is one sentence; `hint` is the next thing to try.
struct Error {
  ErrorCode code = ErrorCode::BadInput;
  std::string where;
  std::string what;
  std::string hint;
};

template <class T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, std::string where, std::string what,
                                                std::string hint = {}) {
  return tl::unexpected<Error>(Error{code, std::move(where), std::move(what), std::move(hint)});
}

}  // namespace rasterdiff
