// Scratch memory that Python keeps, which one call at a time may use.
#pragma once

#include <atomic>
#include <stdexcept>

#include "lasius/planner.h"

namespace lasius::python {

/// A Workspace with the sign that it is in use.
class SharedWorkspace {
 public:
  /// Uses it for as long as it lives. @throws std::runtime_error if another call does.
  class Use {
   public:
    explicit Use(SharedWorkspace* shared) : shared_(shared) {
      if (shared != nullptr && shared->busy_.exchange(true))
        throw std::runtime_error("the workspace is in use by another call: take one a thread");
    }
    ~Use() {
      if (shared_ != nullptr) shared_->busy_ = false;
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    Workspace* get() const noexcept { return shared_ == nullptr ? nullptr : &shared_->workspace_; }

   private:
    SharedWorkspace* shared_;
  };

 private:
  std::atomic<bool> busy_{false};
  Workspace workspace_;
};

}  // namespace lasius::python
