#pragma once

#include <QWidget>

#include "core/study/study.h"

class QFormLayout;
class QLabel;

namespace noonmark {

/// The figures of the latest study.
class ResultsDock final : public QWidget {
    Q_OBJECT
public:
    explicit ResultsDock(QWidget* parent = nullptr);

    void show(const Study* study);    ///< null: none yet
    void setOutdated(bool outdated);  ///< the question has changed since

private:
    QFormLayout* form_;
    QLabel* note_;
    bool filled_ = false;
};

}  // namespace noonmark
