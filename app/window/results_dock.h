#pragma once

#include <QWidget>

#include "app/window/result_rows.h"

class QFormLayout;
class QLabel;

namespace noonmark {

/// The figures of the latest study or comparison.
class ResultsDock final : public QWidget {
    Q_OBJECT
public:
    explicit ResultsDock(QWidget* parent = nullptr);

    void show(const std::vector<ResultRow>& rows);  ///< none: no result yet
    void setOutdated(bool outdated);                ///< the question has changed since

private:
    QFormLayout* form_;
    QLabel* note_;
    bool filled_ = false;
};

}  // namespace noonmark
