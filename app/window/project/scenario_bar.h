#pragma once

#include <QWidget>

class QComboBox;

namespace noonmark {

class ProjectSession;

/// Which scenario is shown, and which one it is compared with: two lists beside the modes.
class ScenarioBar final : public QWidget {
    Q_OBJECT
public:
    explicit ScenarioBar(ProjectSession& session, QWidget* parent = nullptr);  ///< `session` outlives it

private:
    void fill();

    ProjectSession& session_;
    QComboBox* scenario_;
    QComboBox* baseline_;
};

}  // namespace noonmark
