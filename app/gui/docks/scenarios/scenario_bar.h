#pragma once

#include <QWidget>

class QComboBox;

namespace noonmark {

class ProjectSession;

/// Two lists beside the modes: the displayed scenario and its baseline.
class ScenarioBar final : public QWidget {
    Q_OBJECT
public:
    explicit ScenarioBar(ProjectSession& session, QWidget* parent = nullptr);  ///< `session` must outlive it

private:
    void fill();

    ProjectSession& session_;
    QComboBox* scenario_;
    QComboBox* baseline_;
};

}  // namespace noonmark
