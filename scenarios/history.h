#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace noonmark {

/// The states that a value went through: undo and redo without limit, and a mark at the saved one. States
/// are copies; they are small when they share what did not change.
template <class T>
class History {
public:
    /// The first state is clean.
    explicit History(T first) { states_.push_back({std::move(first), {}}); }

    [[nodiscard]] const T& now() const { return states_[now_].value; }

    /// A new state after this one; those that could be redone are gone. `what` names the change in menus.
    void change(T next, std::string what) {
        states_.erase(states_.begin() + std::ptrdiff_t(now_) + 1, states_.end());
        if (clean_ && *clean_ > now_) clean_.reset();
        states_.push_back({std::move(next), std::move(what)});
        ++now_;
    }

    [[nodiscard]] bool canUndo() const { return now_ > 0; }
    [[nodiscard]] bool canRedo() const { return now_ + 1 < states_.size(); }
    /// What undo() would take back; only where canUndo().
    [[nodiscard]] const std::string& undoText() const { return states_[now_].what; }
    /// What redo() would do again; only where canRedo().
    [[nodiscard]] const std::string& redoText() const { return states_[now_ + 1].what; }

    /// The state before or after; the same where there is none.
    const T& undo() {
        if (canUndo()) --now_;
        return now();
    }
    const T& redo() {
        if (canRedo()) ++now_;
        return now();
    }

    /// This state is the saved one.
    void markClean() { clean_ = now_; }
    /// Whether this state is the saved one, by whatever way it was come back to.
    [[nodiscard]] bool isClean() const { return clean_ == now_; }
    [[nodiscard]] std::size_t size() const { return states_.size(); }

private:
    struct State {
        T value;
        std::string what;
    };
    std::vector<State> states_;
    std::size_t now_ = 0;
    std::optional<std::size_t> clean_ = 0;
};

}  // namespace noonmark
