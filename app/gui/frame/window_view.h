#pragma once

#include <map>
#include <string>

namespace noonmark {

class ModeSwitch;
class ReviewSession;
class ViewPanel;
class Workbench;

/// The window's state that is saved in the project: camera, mode, measure, scenario, study, review.
class WindowView {
public:
    /// All must outlive this object.
    WindowView(Workbench& workbench, ViewPanel& panel, ModeSwitch& mode, ReviewSession& review)
        : workbench_(workbench), panel_(panel), mode_(mode), review_(review) {}

    [[nodiscard]] std::map<std::string, std::string> toSave() const;
    /// Shows the project that has been opened as it was saved; a new one from the south, its region in the
    /// middle. Scenario and study are in the workbench already.
    void restore();

private:
    Workbench& workbench_;
    ViewPanel& panel_;
    ModeSwitch& mode_;
    ReviewSession& review_;
};

}  // namespace noonmark
