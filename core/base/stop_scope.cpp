#include "core/base/stop_scope.h"

#include <utility>

namespace noonmark {

namespace {
thread_local const StopScope* innermostScope = nullptr;
}  // namespace

StopScope::StopScope(std::stop_token stop) : stop_(std::move(stop)), outer_(innermostScope) {
    innermostScope = this;
}

StopScope::~StopScope() { innermostScope = outer_; }

bool StopScope::isStopped() {
    for (const StopScope* scope = innermostScope; scope != nullptr; scope = scope->outer_)
        if (scope->stop_.stop_requested()) return true;
    return false;
}

std::stop_token StopScope::current() {
    for (const StopScope* scope = innermostScope; scope != nullptr; scope = scope->outer_)
        if (scope->stop_.stop_possible()) return scope->stop_;
    return {};
}

}  // namespace noonmark
