#pragma once

#include <QWidget>
#include <utility>
#include <vector>

#include "core/study/study.h"

class QFormLayout;
class QLabel;

namespace noonmark {

/// A figure of a study as it is read: name, value with unit, and what it means.
struct Figure {
    QString name;
    QString value;
    QString meaning;
};

std::vector<Figure> figuresOf(const Study& study);

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
