#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace noonmark {

/// Scale and turn of a mesh that is being placed; the place itself is clicked in the view.
class PlacingPanel final : public QWidget {
    Q_OBJECT
public:
    explicit PlacingPanel(QWidget* parent = nullptr);

    void begin(const QString& file);
    void showPlaced(double heightM);  ///< it stands somewhere, so that it can be built
    [[nodiscard]] double scale() const;
    [[nodiscard]] double clockwiseDeg() const;

Q_SIGNALS:
    void edited();
    void applied();
    void cancelled();

private:
    QLabel* what_;
    QDoubleSpinBox* scale_;
    QDoubleSpinBox* turn_;
    QPushButton* apply_;
    QString file_;
};

}  // namespace noonmark
