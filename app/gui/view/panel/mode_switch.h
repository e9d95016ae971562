#pragma once

#include <QObject>
#include <string>

#include "app/gui/session/project/view_mode.h"

class QAction;
class QActionGroup;

namespace noonmark {

class StudyDocument;

/// The three modes as an exclusive action group, kept in step with the study's engine: the ray reference is
/// both a mode and an engine, so each follows the other. Knows no view.
class ModeSwitch final : public QObject {
    Q_OBJECT
public:
    explicit ModeSwitch(StudyDocument& document, QObject* parent = nullptr);  ///< `document` must outlive it

    [[nodiscard]] ViewMode mode() const { return mode_; }
    void setMode(ViewMode mode);
    /// The engine of analysis at first, and after leaving the ray reference. May be the ray reference itself,
    /// if no other engine can run the study.
    void setAnalysisEngine(const std::string& engine) { analysisEngine_ = engine; }
    /// Leaves exploration for the mode of the document's engine.
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
