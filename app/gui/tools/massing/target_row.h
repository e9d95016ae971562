#pragma once

#include <QWidget>

#include "scenarios/massing/fit_floor_area.h"

class QComboBox;
class QDoubleSpinBox;

namespace noonmark {

/// A floor area or a floor area ratio that the tower shall have, and buttons that fit it.
class TargetRow final : public QWidget {
    Q_OBJECT
public:
    explicit TargetRow(QWidget* parent = nullptr);

    [[nodiscard]] FloorAreaTarget target(FloorAreaBy by) const;

Q_SIGNALS:
    void fitRequested(noonmark::FloorAreaTarget target);

private:
    void choose(int kind);

    QComboBox* kind_;
    QDoubleSpinBox* number_;
};

}  // namespace noonmark
