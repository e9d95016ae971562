#pragma once

#include <QObject>
#include <string>

#include "app/window/view/view_mode.h"

class QAction;
class QActionGroup;

namespace noonmark {

class StudyDocument;

/// The three modes as actions of which one is checked, and the engine that goes with them: the ray reference
/// is a mode and an engine, so each follows the other. Knows no view.
class ModeSwitch final : public QObject {
    Q_OBJECT
public:
    explicit ModeSwitch(StudyDocument& document, QObject* parent = nullptr);  ///< `document` outlives it

    [[nodiscard]] ViewMode mode() const { return mode_; }
    void setMode(ViewMode mode);
    /// What analysis begins with, and comes back to from the ray reference; may be the ray reference itself,
    /// where no other engine can do it.
    void setAnalysisEngine(const std::string& engine) { analysisEngine_ = engine; }
    /// From exploration to where a study of the document's engine is shown.
    void showStudies();

    [[nodiscard]] QList<QAction*> actions() const;

Q_SIGNALS:
    void changed(noonmark::ViewMode mode);

private:
    void makeAction(ViewMode mode, const QKeySequence& keys);
    void enter(ViewMode mode);
    void takeEngine(const std::string& engine);
    void followDocument();

    StudyDocument& document_;
    QActionGroup* group_;
    ViewMode mode_ = ViewMode::exploration;
    std::string analysisEngine_;
};

}  // namespace noonmark
