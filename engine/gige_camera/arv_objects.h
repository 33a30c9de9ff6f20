#pragma once
// GLib's objects and errors as C++ owns them. Only for this room.

#include <arv.h>
#include <memory>
#include <string>

namespace vignole::gige {

struct Unref {
  void operator()(void* object) const { g_object_unref(object); }
};
template <typename T>
using Owned = std::unique_ptr<T, Unref>;

/// One GError, looked at after every call that takes it.
class Failure {
 public:
  Failure() = default;
  ~Failure() { g_clear_error(&error_); }
  Failure(const Failure&) = delete;
  Failure& operator=(const Failure&) = delete;
  /// For the next call.
  operator GError**() {  // NOLINT: what Aravis takes
    g_clear_error(&error_);
    return &error_;
  }
  [[nodiscard]] bool any() const { return error_ != nullptr; }
  [[nodiscard]] std::string message() const { return error_ == nullptr ? std::string() : error_->message; }
  [[nodiscard]] bool accessDenied() const {
    return error_ != nullptr && error_->domain == ARV_DEVICE_ERROR &&
           (error_->code == ARV_DEVICE_ERROR_NOT_CONTROLLER ||
            error_->code == ARV_DEVICE_ERROR_PROTOCOL_ERROR_ACCESS_DENIED);
  }

 private:
  GError* error_ = nullptr;
};

}  // namespace vignole::gige
