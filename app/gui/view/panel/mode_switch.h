#pragma once

#include <QObject>

#include "app/gui/session/project/view_mode.h"

class QAction;
class QActionGroup;

namespace noonmark {

/// The three modes as an exclusive action group. Knows no view.
class ModeSwitch final : public QObject {
    Q_OBJECT
public:
    explicit ModeSwitch(QObject* parent = nullptr);

    [[nodiscard]] ViewMode mode() const { return mode_; }
    void setMode(ViewMode mode);
    void showStudies();  ///< leaves exploration, which shows no study

    [[nodiscard]] QList<QAction*> actions() const;

Q_SIGNALS:
    void changed(noonmark::ViewMode mode);

private:
    void makeAction(ViewMode mode, const QKeySequence& keys);

    QActionGroup* group_;
    ViewMode mode_ = ViewMode::exploration;
};

}  // namespace noonmark
