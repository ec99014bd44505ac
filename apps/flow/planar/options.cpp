// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/flow/planar/options.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "apps/common/number_list.h"
#include "apps/flow/options.h"
#include "apps/flow/planar/names.h"
#include "core/errors.h"
#include "io/number.h"

namespace dsc::flow::planar {

namespace {

class Parser {
public:
    Parser(const apps::CommandLine& line, const flow::Options& common, const Texts& texts)
        : line_(line), given_(line.given()), common_(common), texts_(texts) {}

    Options run() {
        parse_shape();
        parse_motion();
        check_uses();
        return std::move(options_);
    }

private:
    std::optional<std::string> text(const std::string& option) const {
        if (!line_.is_given(option)) return std::nullopt;
        return given_[option].string();
    }

    std::vector<double> numbers(const std::string& option) const {
        return apps::parsed_numbers(option, given_[option].string());
    }

    std::optional<Point2> point(const std::string& option) const {
        if (!line_.is_given(option)) return std::nullopt;
        return apps::parsed_point<2>(option, given_[option].string());
    }

    void parse_shape() {
        ShapeOptions& shape = options_.shape;
        const std::string name = given_["SHAPE"].string();
        const auto found = std::ranges::find(shape_names, name, [](const auto& entry) { return entry.name; });
        shape.shape = found == shape_names.end() ? Shape::file : found->value;
        if (shape.shape == Shape::file) {
            shape.path = name;
            if (name.find('.') == std::string::npos) {
                std::string list;
                for (const std::string& known : all_names(shape_names)) list += (list.empty() ? "" : ", ") + known;
                throw core::UsageError("\"" + name + "\" is neither a shape of the plane (" + list +
                                       ") nor a file with an extension");
            }
        }
        shape.centre = point("--center").value_or(shape.centre);
        shape.radius = common_.shape.radius;
        shape.minor_radius = common_.shape.minor_radius;
        shape.spread = common_.shape.spread;
        shape.gap = common_.shape.gap;
        shape.slot_width = common_.shape.slot_width;
        shape.slot_depth = common_.shape.slot_depth;
        shape.edge_length = common_.shape.edge_length;
        shape.is_torus = texts_.is_torus;
        shape.sides = texts_.sides;
        if (line_.is_given("--size")) {
            const std::vector<double> list = numbers("--size");
            if (list.size() > 2)
                throw core::UsageError("--size: \"" + given_["--size"].string() + "\" is not one or two lengths");
            shape.size = Point2(list.front(), list.back());
            if (shape.size->minCoeff() <= 0) throw core::UsageError("--size: lengths have to be positive");
        }
        if (line_.is_given("--domain")) {
            const std::vector<double> n = numbers("--domain");
            if (n.size() != 4 || !(n[0] < n[2] && n[1] < n[3]))
                throw core::UsageError("--domain: \"" + given_["--domain"].string() +
                                       "\" is not x0,y0,x1,y1 with the lower corner first");
            shape.domain = Eigen::AlignedBox2d(Point2(n[0], n[1]), Point2(n[2], n[3]));
        }
    }

    void parse_motion() {
        MotionOptions& motion = options_.motion;
        const std::string name = text("--motion").value_or("rotate");
        const auto found = std::ranges::find(motion_names, name, [](const auto& entry) { return entry.name; });
        if (found == motion_names.end())
            throw core::UsageError("--motion " + name + ": is there in three dimensions only");
        motion.motion = found->value;
        motion.about = point("--about");
        motion.angle = common_.motion.angle;
        motion.distance = common_.motion.distance.value_or(0);
        motion.period = common_.motion.period;
        motion.speed = common_.motion.speed;
        motion.frequency = common_.motion.frequency;
        motion.seed = static_cast<std::uint64_t>(common_.common.seed);
        motion.has_walls = !texts_.is_torus;
        motion.direction = point("--direction").value_or(motion.direction);
        motion.gradient = point("--gradient").value_or(motion.gradient);
        motion.array = text("--array").value_or("");
        motion.path = motion.motion == Motion::grid ? text("--velocity").value_or("") : "";
        if (motion.motion == Motion::grid && motion.path.empty())
            throw core::UsageError("--motion grid needs --velocity FILE.vti");
        if (motion.motion == Motion::offset && !common_.motion.distance)
            throw core::UsageError("--motion offset needs --distance");
        if (motion.motion == Motion::translate) {
            const std::optional<Point2> velocity = point("--velocity");
            if (!velocity) throw core::UsageError("--motion translate needs --velocity x,y");
            motion.velocity = *velocity;
        }
        if (motion.motion == Motion::expression) {
            const std::optional<std::string> expressions = text("--velocity");
            if (!expressions) throw core::UsageError("--motion expression needs --velocity \"(-y, x)\"");
            motion.expressions = *expressions;
        }
    }

    // An option that the shape or motion has no use for is a mistake that would go unseen.
    void require_use(const std::string& option, const std::set<std::string>& users, const std::string& user) const {
        if (!line_.is_given(option) || users.contains(user)) return;
        std::string list;
        for (const std::string& name : users) list += (list.empty() ? "" : ", ") + name;
        throw core::UsageError(option + ": goes with " + list + " only");
    }

    void check_uses() const {
        for (const char* option : {"--axis", "--feature-angle", "--growth"})
            if (line_.is_given(option))
                throw core::UsageError(std::string(option) + ": is there in three dimensions only");
        const bool is_file = options_.shape.shape == Shape::file;
        const std::string shape = is_file ? "file" : name_of(shape_names, options_.shape.shape);
        require_use("--center",
                    {"disc", "two-discs", "ring", "dumbbell", "slotted-disc", "polygon", "box", "labelled-block"},
                    shape);
        require_use("--radius", {"disc", "two-discs", "ring", "dumbbell", "slotted-disc", "polygon"}, shape);
        require_use("--minor-radius", {"ring", "dumbbell"}, shape);
        require_use("--spread", {"dumbbell"}, shape);
        require_use("--gap", {"two-discs"}, shape);
        require_use("--size", {"box", "labelled-block"}, shape);
        require_use("--slot-width", {"slotted-disc"}, shape);
        require_use("--slot-depth", {"slotted-disc"}, shape);
        require_use("--sides", {"polygon"}, shape);
        const std::string motion = name_of(motion_names, options_.motion.motion);
        require_use("--about", {"rotate", "shear"}, motion);
        require_use("--angle", {"rotate"}, motion);
        require_use("--distance", {"offset"}, motion);
        require_use("--period", {"vortex"}, motion);
        require_use("--speed", {"curl-noise"}, motion);
        require_use("--frequency", {"curl-noise"}, motion);
        require_use("--direction", {"shear"}, motion);
        require_use("--gradient", {"shear"}, motion);
        require_use("--velocity", {"translate", "expression", "grid"}, motion);
        require_use("--array", {"grid"}, motion);
    }

    const apps::CommandLine& line_;
    const io::Json given_;
    const flow::Options& common_;
    const Texts& texts_;
    Options options_;
};

}  // namespace

void add_options(apps::CommandLine& line, Texts& texts) {
    line.integer("--sides", texts.sides, "of a regular polygon (2D)", {.at_least = 3, .at_most = 1e5});
    line.flag("--torus", texts.is_torus, "the domain repeats itself in both directions (2D)");
}

bool is_any_given(const apps::CommandLine& line) { return line.is_given("--sides") || line.is_given("--torus"); }

Options parsed_options(const apps::CommandLine& line, const flow::Options& common, const Texts& texts) {
    return Parser(line, common, texts).run();
}

}  // namespace dsc::flow::planar
