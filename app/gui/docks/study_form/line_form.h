#pragma once

#include <QWidget>

#include "core/receivers/points/point_list.h"
#include "core/study/elements/place_elements.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace noonmark {

/// Lines around a parcel: which parcel, how far from it, how far from point to point.
class LineForm final : public QWidget {
    Q_OBJECT
public:
    explicit LineForm(QWidget* parent = nullptr);

    void show(const std::string& parcel, const LineSettings& lines);  ///< without a signal
    void setLots(const QStringList& names);                           ///< of the project, to choose from

Q_SIGNALS:
    void edited(std::string parcel, noonmark::LineSettings lines, QString field);

private:
    void makeFields();
    void connectFields();
    void takeOffsets();

    std::string chosen_;
    LineSettings lines_;
    QComboBox* parcel_;
    QLineEdit* offsets_;
    QDoubleSpinBox* spacing_;
};

/// A list of single points: typed one a line, read from a CSV file, or clicked in the view.
class PointListForm final : public QWidget {
    Q_OBJECT
public:
    explicit PointListForm(QWidget* parent = nullptr);

    void show(const std::vector<ListedPoint>& points);  ///< without a signal
    void add(ListedPoint point);                        ///< named after its number
    void endPicking();
    [[nodiscard]] bool picking() const;

Q_SIGNALS:
    void edited(std::vector<noonmark::ListedPoint> points, QString field);
    void pickingBegan();  ///< the next clicks on the view are for add()

private:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void take();
    void readFile();
    void report(const QString& problem);

    std::vector<ListedPoint> points_;
    QPlainTextEdit* text_;
    QPushButton* pick_;
    QPushButton* read_;
    QLabel* problem_;
};

}  // namespace noonmark
