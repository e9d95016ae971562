#pragma once

#include <memory>

class QApplication;

namespace noonmark::cli {

/// What text, maps and charts need of Qt to be drawn into files: an application, without a display. Remarks
/// of Qt about the machine (a missing runtime folder, say) are nothing to a user and stay away; what fails
/// still comes out. Where there is an application already it is left alone.
class OffscreenQt {
public:
    OffscreenQt();
    ~OffscreenQt();
    OffscreenQt(const OffscreenQt&) = delete;
    OffscreenQt& operator=(const OffscreenQt&) = delete;

private:
    // What the application keeps references to.
    int argc_ = 1;
    char name_[13] = "noonmark-cli";
    char* argv_[2] = {name_, nullptr};
    std::unique_ptr<QApplication> application_;
};

}  // namespace noonmark::cli
