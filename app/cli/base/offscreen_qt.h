#pragma once

#include <memory>

class QApplication;

namespace noonmark::cli {

/// A Qt application without a display, whatever platform the environment names: drawing text, maps and charts
/// into files requires one. Suppresses Qt's messages about the environment (a missing runtime folder, for
/// example); errors still appear. Does nothing if an application exists.
class OffscreenQt {
public:
    OffscreenQt();
    ~OffscreenQt();
    OffscreenQt(const OffscreenQt&) = delete;
    OffscreenQt& operator=(const OffscreenQt&) = delete;

private:
    // The application keeps references to these.
    int argc_ = 1;
    char name_[13] = "noonmark-cli";
    char* argv_[2] = {name_, nullptr};
    std::unique_ptr<QApplication> application_;
};

}  // namespace noonmark::cli
