#pragma once

#include <QSlider>
#include <vector>

namespace noonmark {

/// A horizontal slider with named marks below its groove and a brighter part of the groove. A click moves the
/// handle to the place that was clicked.
class MarkedSlider final : public QSlider {
    Q_OBJECT
public:
    struct Mark {
        int value = 0;
        QString label;         ///< empty: a tick only
        QString shortLabel{};  ///< for all marks where the labels do not fit; empty: the label
        bool operator==(const Mark&) const = default;
    };

    explicit MarkedSlider(QWidget* parent = nullptr);

    void setMarks(std::vector<Mark> marks);
    [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
    /// The values between which the groove is bright, such as sunrise and sunset.
    void setBright(int first, int last);

    /// A label as it is painted.
    struct Label {
        QString text;
        QRectF box;
    };
    /// The labels that fit beside each other: all, all in their short form, or the first, third...
    [[nodiscard]] std::vector<Label> labels() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] int handleWidth() const;
    [[nodiscard]] double pixelOf(int value) const;
    [[nodiscard]] std::vector<Label> allLabels(bool shortened) const;

    std::vector<Mark> marks_;
    int firstBright_ = 0, lastBright_ = -1;
};

}  // namespace noonmark
