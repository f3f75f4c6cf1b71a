#include "core/lights/light_list.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/maths/portable_math.h"

namespace dapple {

namespace {

struct Three {
    glm::dvec3 of;
    std::string_view between;
};
TextBuffer& operator<<(TextBuffer& text, const Three& three) {
    const auto& [v, between] = three;
    return text << v.x << between << v.y << between << v.z;
}

// Printable ASCII.
char printable(char c) {
    return c < ' ' || c > '~' ? '?' : c;
}

std::string json_text(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        if (c == '"' || c == '\\') text += '\\';
        text += printable(c);
    }
    return text;
}

// A name within a comment must neither end it nor the line.
std::string comment_text(std::string_view bytes) {
    std::string text = json_text(bytes);
    std::ranges::replace(text, '-', '_');
    return text;
}

// What the first comment of a file says.
void put_what_it_is(TextBuffer& text, const LightSamples& lights, const LightListStyle& style) {
    text << static_cast<std::int64_t>(lights.samples.size()) << " lights from " << comment_text(style.source)
         << ", convention " << name_of(style.convention) << ", turned by " << style.rotation_degrees
         << " degrees; total flux " << Three{lights.total_flux, " "};
}

// Turns +Z to the direction; such lights shine the other way.
struct Quaternion {
    double w, x, y, z;

    explicit Quaternion(const glm::dvec3& to) {
        // Half the angle, about the axis at right angles to both.
        const double length = std::sqrt(std::max(2 * (1 + to.z), 0.0));
        if (length < 1e-6)
            w = 0, x = 1, y = 0, z = 0;
        else
            w = length / 2, x = -to.y / length, y = to.x / length, z = 0;
    }
};

// A colour whose largest part is 1, and how strong it is.
struct Strength {
    double most;
    glm::dvec3 colour;

    explicit Strength(const glm::dvec3& weight)
        : most(std::max({weight.r, weight.g, weight.b})), colour(most > 0 ? weight / most : glm::dvec3(1)) {}
};

// Zeros without a sign.
glm::dvec3 negated(const glm::dvec3& v) {
    return glm::dvec3(0) - v;
}

}  // namespace

glm::dvec3 direction_of(const LightSample& sample, const LightListStyle& style) {
    return turned_about_up(direction_of(sample.uv, style.convention), style.rotation_degrees,
                           style.convention);
}

double angular_radius(const LightSample& sample, std::size_t samples) {
    const double solid_angle = 1 / (static_cast<double>(samples) * sample.pdf);
    return portable::acos(std::clamp(1 - solid_angle / (2 * std::numbers::pi), -1.0, 1.0)) * 180 /
           std::numbers::pi;
}

void write_light_json(TextBuffer& text, const LightSamples& lights, const LightListStyle& style) {
    text << "{\n\"convention\": \"" << name_of(style.convention)
         << "\",\n\"rotation_degrees\": " << style.rotation_degrees << ",\n\"source\": \""
         << json_text(style.source) << "\",\n\"position\": \"" << name_of(lights.position)
         << "\",\n\"radiance\": \"" << name_of(lights.radiance) << "\",\n\"order\": \""
         << name_of(lights.order) << "\",\n\"seed\": " << std::to_string(lights.seed)
         << ",\n\"count\": " << static_cast<std::int64_t>(lights.samples.size()) << ",\n\"total_flux\": ["
         << Three{lights.total_flux, ", "} << "],\n\"samples\": [";
    bool first = true;
    for (const LightSample& sample : lights.samples)
        text << (std::exchange(first, false) ? "\n{\"direction\": [" : ",\n{\"direction\": [")
             << Three{direction_of(sample, style), ", "} << "], \"u\": " << sample.uv.x
             << ", \"v\": " << sample.uv.y << ", \"radiance\": [" << Three{sample.radiance, ", "}
             << "], \"pdf\": " << sample.pdf << ", \"weight\": [" << Three{sample.weight, ", "}
             << "], \"angular_radius\": " << angular_radius(sample, lights.samples.size()) << '}';
    text << "\n]\n}\n";
}

void write_light_csv(TextBuffer& text, const LightSamples& lights, const LightListStyle& style) {
    std::string source(style.source);
    std::ranges::transform(source, source.begin(), printable);
    text << "# convention: " << name_of(style.convention)
         << "\n# rotation_degrees: " << style.rotation_degrees << "\n# source: " << source
         << "\n# position: " << name_of(lights.position) << "\n# radiance: " << name_of(lights.radiance)
         << "\n# order: " << name_of(lights.order) << "\n# seed: " << std::to_string(lights.seed)
         << "\n# count: " << static_cast<std::int64_t>(lights.samples.size())
         << "\n# total_flux: " << Three{lights.total_flux, " "} << '\n';
    text << "x,y,z,u,v,radiance_r,radiance_g,radiance_b,pdf,weight_r,weight_g,weight_b,angular_radius\n";
    for (const LightSample& sample : lights.samples)
        text << Three{direction_of(sample, style), ","} << ',' << sample.uv.x << ',' << sample.uv.y << ','
             << Three{sample.radiance, ","} << ',' << sample.pdf << ',' << Three{sample.weight, ","} << ','
             << angular_radius(sample, lights.samples.size()) << '\n';
}

void write_light_pbrt(TextBuffer& text, const LightSamples& lights, const LightListStyle& style) {
    text << "# ";
    put_what_it_is(text, lights, style);
    text << "\n";
    for (const LightSample& sample : lights.samples)
        text << "LightSource \"distant\" \"point3 from\" [ " << Three{direction_of(sample, style), " "}
             << " ] \"point3 to\" [ 0 0 0 ] \"rgb L\" [ " << Three{sample.weight, " "}
             << " ] \"float scale\" [ 1 ]\n";
}

void write_light_mitsuba(TextBuffer& text, const LightSamples& lights, const LightListStyle& style) {
    text << "<scene version=\"3.0.0\">\n    <!-- ";
    put_what_it_is(text, lights, style);
    text << " -->\n";
    for (const LightSample& sample : lights.samples) {
        const glm::dvec3 travel = negated(direction_of(sample, style));
        text << "    <emitter type=\"directional\"><vector name=\"direction\" x=\"" << travel.x << "\" y=\""
             << travel.y << "\" z=\"" << travel.z << "\"/><rgb name=\"irradiance\" value=\""
             << Three{sample.weight, ", "} << "\"/></emitter>\n";
    }
    text << "</scene>\n";
}

void write_light_usd(TextBuffer& text, const LightSamples& lights, const LightListStyle& style) {
    text << "#usda 1.0\n(\n    doc = \"";
    put_what_it_is(text, lights, style);
    text << "\"\n    defaultPrim = \"Lights\"\n    upAxis = \"Y\"\n)\n\ndef Xform \"Lights\"\n{\n";
    std::int64_t number = 0;
    for (const LightSample& sample : lights.samples) {
        const Quaternion turn(direction_of(sample, style));
        const double width = 2 * angular_radius(sample, lights.samples.size());
        text << "    def DistantLight \"Light_" << number++
             << "\"\n    {\n        float inputs:angle = " << std::min(width, 180.0)
             << "\n        color3f inputs:color = (" << Three{sample.weight, ", "}
             << ")\n        float inputs:intensity = 1\n        bool inputs:normalize = 1\n"
                "        quatf xformOp:orient = ("
             << turn.w << ", " << turn.x << ", " << turn.y << ", " << turn.z
             << ")\n        uniform token[] xformOpOrder = [\"xformOp:orient\"]\n    }\n";
    }
    text << "}\n";
}

void write_light_gltf(TextBuffer& text, const LightSamples& lights, const LightListStyle& style) {
    text << "{\n\"asset\": {\"version\": \"2.0\", \"generator\": \"Dapple\", \"extras\": {\"what\": \"";
    put_what_it_is(text, lights, style);
    text << "\"}},\n\"extensionsUsed\": [\"KHR_lights_punctual\"],\n\"extensions\": "
            "{\"KHR_lights_punctual\": {\"lights\": [";
    for (std::size_t i = 0; i < lights.samples.size(); ++i) {
        const Strength strength(lights.samples[i].weight);
        text << (i == 0 ? "" : ",") << "\n{\"type\": \"directional\", \"color\": ["
             << Three{strength.colour, ", "} << "], \"intensity\": " << strength.most << '}';
    }
    text << "\n]}},\n\"scene\": 0,\n\"scenes\": [{\"nodes\": [0]}],\n\"nodes\": [\n{\"name\": \"Lights\", "
            "\"children\": [";
    for (std::size_t i = 1; i <= lights.samples.size(); ++i)
        text << (i == 1 ? "" : ", ") << static_cast<std::int64_t>(i);
    text << "]}";
    std::int64_t number = 0;
    for (const LightSample& sample : lights.samples) {
        const Quaternion turn(direction_of(sample, style));
        text << ",\n{\"rotation\": [" << turn.x << ", " << turn.y << ", " << turn.z << ", " << turn.w
             << "], \"extensions\": {\"KHR_lights_punctual\": {\"light\": " << number++ << "}}}";
    }
    text << "\n]\n}\n";
}

void write_light_blender(TextBuffer& text, const LightSamples& lights, const LightListStyle& style) {
    text << "# ";
    put_what_it_is(text, lights, style);
    text << "\n# To be run in Blender: blender scene.blend --python THIS_FILE. The world's own light is left "
            "as it is.\nimport bpy\n\n# The rotation w, x, y, z, the colour, the strength, the width in "
            "radians.\n"
            "lights = [\n";
    for (const LightSample& sample : lights.samples) {
        const Quaternion turn(direction_of(sample, style));
        const Strength strength(sample.weight);
        const double radius = angular_radius(sample, lights.samples.size()) * std::numbers::pi / 180;
        text << "    ((" << turn.w << ", " << turn.x << ", " << turn.y << ", " << turn.z << "), ("
             << Three{strength.colour, ", "} << "), " << strength.most << ", "
             << std::min(2 * radius, std::numbers::pi) << "),\n";
    }
    text << R"(]
collection = bpy.data.collections.new("Lights")
bpy.context.scene.collection.children.link(collection)
for rotation, colour, strength, width in lights:
    light = bpy.data.lights.new("Light", "SUN")
    light.color, light.energy, light.angle = colour, strength, width
    sun = bpy.data.objects.new("Light", light)
    sun.rotation_mode, sun.rotation_quaternion = "QUATERNION", rotation
    collection.objects.link(sun)
)";
}

}  // namespace dapple
