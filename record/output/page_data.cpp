// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See page.h for how it is packed. Every array begins at a multiple of four bytes, since a browser's typed
// arrays must.
#include "record/output/page_data.h"

#include <algorithm>
#include <cmath>

#include "record/file/bytes.h"
#include "record/output/animation.h"
#include "record/output/json.h"
#include "record/output/palette.h"
#include "record/output/tessellate.h"

namespace epode::record {

namespace {

constexpr size_t kContactBytes = 11;
constexpr size_t kContactBudget = size_t(2) << 20;
constexpr size_t kMaxSeries = 5000;

std::uint16_t sixteen(double part) { return std::uint16_t(std::lround(std::clamp(part, 0.0, 1.0) * 65535)); }

// A box and where in it points are.
struct Box {
    Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    void add(const Vec3& p)
    {
        for (size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    bool empty() const { return !(low[0] <= high[0]); }
    double extent(size_t i) const { return empty() ? 0 : high[i] - low[i]; }
    double part(size_t i, double value) const { return extent(i) > 0 ? (value - low[i]) / extent(i) : 0; }
};

bool finite(const float (&v)[3]) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

float normal_force(const Contact& contact)
{
    float sum = 0;
    for (size_t i = 0; i < 3; ++i) sum += contact.force[i] * contact.normal[i];
    return std::isfinite(sum) ? std::max(0.f, sum) : 0.f;
}

class PageBuilder {
  public:
    PageBuilder(const Recording& recording, double fps)
        : recording_(recording), animation_(make_animation(recording, fps))
    {}

    PageData build()
    {
        json_.object();
        json_.key("about").object();
        for (const auto& [key, value] : recording_.about) json_.key(key.c_str()).value(value);
        json_.end_object();
        diagnosis();
        json_.key("bodies").value(recording_.bodies.size());
        json_.key("palette").array();
        for (std::uint32_t i = 0; i < kColors; ++i) json_.values(color(i));
        json_.end_array();
        moments();
        solids();
        parts();
        carriers();
        series();
        contacts();
        joints();
        json_.end_object();
        return {json_.text(), block_.bytes(), smooth_};
    }

  private:
    void diagnosis()
    {
        json_.key("diagnosis").array();
        for (size_t i = 1;; ++i) {
            const std::string text = recording_.about_value(kDiagnosisKey + std::to_string(i));
            if (text.empty()) break;
            json_.value(text);
        }
        json_.end_array();
    }

    // A key of the head with [offset, number of values]; `fill` writes them.
    template <class Fill>
    void array(const char* name, size_t bytes_each, Fill fill)
    {
        while (block_.bytes().size() % 4 != 0) block_.u8(0);
        const size_t offset = block_.bytes().size();
        fill();
        last_ = {offset, (block_.bytes().size() - offset) / bytes_each, 1};
        json_.key(name).array().value(last_.offset).value(last_.values).end_array();
    }

    // The last array has rows of so many numbers, one after the other in time.
    void is_smooth(size_t width)
    {
        last_.width = width;
        smooth_.push_back(last_);
    }

    void moments()
    {
        array("times", 4, [&] {
            for (float time : animation_.times) block_.f32(time);
        });
        array("hashes", 4, [&] {
            for (size_t step : animation_.steps) block_.u64(recording_.steps[step].hash);
        });
        json_.key("steps").array();
        for (size_t step : animation_.steps) json_.value(step);
        json_.end_array();
    }

    void solids()
    {
        const double reach = std::max(1000.0, 20 * animation_.reach);
        json_.key("solids").array();
        for (const Shape& solid : animation_.solids) {
            const Surface surface = tessellate(solid, reach);
            json_.object().key("kind").value(int(solid.kind));
            array("points", 4, [&] { put_rows(surface.points); });
            array("normals", 4, [&] { put_rows(surface.normals); });
            array("corners", 4, [&] {
                for (std::uint32_t corner : surface.corners) block_.u32(corner);
            });
            json_.end_object();
        }
        json_.end_array();
    }

    void put_rows(const std::vector<std::array<float, 3>>& rows)
    {
        for (const auto& row : rows) {
            for (float value : row) block_.f32(value);
        }
    }

    void put_floats(const Vec3& values)
    {
        for (double value : values) block_.f32(float(value));
    }

    void parts()
    {
        json_.key("parts").object().key("count").value(animation_.parts.size());
        array("numbers", 4, [&] {
            for (const Part& part : animation_.parts) {
                block_.u32(part.solid);
                block_.i32(part.carrier);
                block_.u32(color_number(part.body));
                block_.i32(part.body);
            }
        });
        array("poses", 4, [&] {
            for (const Part& part : animation_.parts) {
                put_floats(part.pose.pos);
                for (double value : part.pose.turn) block_.f32(float(value));
                put_floats(part.scale);
            }
        });
        json_.end_object();
    }

    // The keys [first, last] outside of which a carrier stays where it was.
    static std::pair<size_t, size_t> busy(const std::vector<Pose>& poses)
    {
        const auto same = [&](size_t a, size_t b) {
            return poses[a].pos == poses[b].pos && poses[a].turn == poses[b].turn;
        };
        size_t first = 0, last = poses.size() - 1;
        while (first < last && same(first, first + 1)) ++first;
        while (last > first && same(last, last - 1)) --last;
        return {first, last};
    }

    void carriers()
    {
        json_.key("carriers").object().key("count").value(animation_.carriers.size());
        std::vector<Box> boxes;
        std::vector<std::pair<size_t, size_t>> spans;
        for (const Carrier& carrier : animation_.carriers) {
            boxes.emplace_back();
            for (const Pose& pose : carrier.poses) boxes.back().add(pose.pos);
            spans.push_back(carrier.poses.empty() ? std::pair<size_t, size_t>{0, 0} : busy(carrier.poses));
        }
        const auto each_key = [&](auto put) {
            for (size_t i = 0; i < animation_.carriers.size(); ++i) {
                const auto& poses = animation_.carriers[i].poses;
                for (size_t key = spans[i].first; key <= spans[i].second && key < poses.size(); ++key)
                    put(i, poses[key]);
            }
        };
        array("numbers", 4, [&] {
            size_t start = 0;
            for (size_t i = 0; i < animation_.carriers.size(); ++i) {
                const size_t count = spans[i].second - spans[i].first + 1;
                block_.i32(animation_.carriers[i].body);
                block_.u32(std::uint32_t(spans[i].first));
                block_.u32(std::uint32_t(count));
                block_.u32(std::uint32_t(start));
                start += count;
            }
        });
        array("frames", 4, [&] {
            for (const Box& box : boxes) {
                put_floats(box.empty() ? Vec3{} : box.low);
                put_floats({box.extent(0), box.extent(1), box.extent(2)});
            }
        });
        array("positions", 2, [&] {
            each_key([&](size_t i, const Pose& pose) {
                for (size_t k = 0; k < 3; ++k) put16(sixteen(boxes[i].part(k, pose.pos[k])));
            });
        });
        is_smooth(3);
        array("turns", 2, [&] {
            each_key([&](size_t, const Pose& pose) {
                for (double value : pose.turn) put16(std::uint16_t(std::int16_t(std::lround(value * 32767))));
            });
        });
        is_smooth(4);
        lives();
        json_.end_object();
    }

    void lives()
    {
        json_.key("lives").array();
        for (size_t i = 0; i < animation_.carriers.size(); ++i) {
            const Carrier& carrier = animation_.carriers[i];
            if (carrier.always_alive) continue;
            json_.array().value(i);
            for (size_t k = 0; k < carrier.alive.size(); ++k) {
                if (k == 0 || carrier.alive[k] != carrier.alive[k - 1])
                    json_.value(k).value(int(carrier.alive[k]));
            }
            json_.end_array();
        }
        json_.end_array();
    }

    void put16(std::uint16_t value)
    {
        block_.u8(std::uint8_t(value & 255));
        block_.u8(std::uint8_t(value >> 8));
    }

    // Every state, or every n-th where there are very many.
    void series()
    {
        const size_t stride = 1 + recording_.steps.size() / kMaxSeries;
        const auto one = [&](const char* name, auto value) {
            array(name, 4, [&] {
                for (size_t i = 0; i < recording_.steps.size(); i += stride)
                    block_.f32(float(value(recording_.steps[i])));
            });
        };
        json_.key("series").object();
        one("times", [](const Step& step) { return step.time; });
        one("kinetic", [](const Step& step) { return step.kinetic; });
        one("potential", [](const Step& step) { return step.potential; });
        one("joint_error", [](const Step& step) { return step.joint_error; });
        one("ms", [](const Step& step) { return step.ms; });
        json_.end_object();
    }

    void contacts()
    {
        size_t all = 0;
        for (size_t step : animation_.steps) all += recording_.steps[step].contacts.size();
        const size_t stride = 1 + all * kContactBytes / kContactBudget;
        std::vector<const Contact*> chosen;
        std::vector<size_t> starts;
        Box box;
        float largest = 0;
        for (size_t moment = 0; moment < animation_.steps.size(); moment += stride) {
            starts.push_back(chosen.size());
            for (const Contact& contact : recording_.steps[animation_.steps[moment]].contacts) {
                if (!finite(contact.pos) || !finite(contact.normal)) continue;
                chosen.push_back(&contact);
                box.add({contact.pos[0], contact.pos[1], contact.pos[2]});
                largest = std::max(largest, normal_force(contact));
            }
        }
        starts.push_back(chosen.size());
        write_contacts(stride, chosen, starts, box, largest);
    }

    void write_contacts(size_t stride, const std::vector<const Contact*>& chosen,
                        const std::vector<size_t>& starts, const Box& box, float largest)
    {
        json_.key("contacts").object().key("stride").value(stride).key("force").value(double(largest));
        json_.key("low").values(box.empty() ? Vec3{} : box.low);
        json_.key("extent")
            .array()
            .value(box.extent(0))
            .value(box.extent(1))
            .value(box.extent(2))
            .end_array();
        json_.key("counts").array();
        for (size_t step : animation_.steps) json_.value(recording_.steps[step].contacts.size());
        json_.end_array();
        array("starts", 4, [&] {
            for (size_t start : starts) block_.u32(std::uint32_t(start));
        });
        array("places", 2, [&] {
            for (const Contact* contact : chosen) {
                for (size_t i = 0; i < 3; ++i) put16(sixteen(box.part(i, contact->pos[i])));
            }
        });
        array("normals", 1, [&] {
            for (const Contact* contact : chosen) {
                for (float value : contact->normal)
                    block_.u8(std::uint8_t(std::int8_t(std::lround(127 * std::clamp(value, -1.f, 1.f)))));
            }
        });
        array("forces", 2, [&] {
            for (const Contact* contact : chosen)
                put16(largest > 0 ? sixteen(double(normal_force(*contact) / largest)) : 0);
        });
        json_.end_object();
    }

    // The carrier of a body has the body's number.
    void joints()
    {
        json_.key("joints").object().key("count").value(recording_.joints.size());
        array("carriers", 4, [&] {
            for (const Joint& joint : recording_.joints) {
                for (std::int32_t body : joint.body) block_.i32(body);
            }
        });
        array("anchors", 4, [&] {
            for (const Joint& joint : recording_.joints) {
                for (size_t i = 0; i < 2; ++i)
                    put_floats(joint.has_anchor[i] ? joint.anchor[i] : Vec3{NAN, NAN, NAN});
            }
        });
        json_.end_object();
    }

    const Recording& recording_;
    Animation animation_;
    Json json_;
    ByteWriter block_;
    Columns last_;
    std::vector<Columns> smooth_;
};

}  // namespace

PageData make_page_data(const Recording& recording, double fps)
{
    return PageBuilder(recording, fps).build();
}

}  // namespace epode::record
