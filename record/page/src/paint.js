// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How solids are lit: a sun, a sky that is brighter above than below, and some light from everywhere, all diffuse. Light is computed at
// the corners, once with the sun and once in its shadow, and already as the screen's sRGB; a pixel only mixes the two by its shadow and
// adds haze. On flat faces that is exact. Three's MeshLambertMaterial, which does all of it a pixel, took 1.5 times as long where a
// processor draws.
import {ShaderMaterial, UniformsLib, UniformsUtils, Vector3} from 'three';

export const kSunDirection = new Vector3(-1.2, -1, 1.8).normalize();

const kVertex = `
#include <common>
#include <fog_pars_vertex>
#include <shadowmap_pars_vertex>
uniform vec3 sun_direction;
varying vec3 in_sun, in_shadow;
vec3 srgb(vec3 c) { return mix(1.055 * pow(c, vec3(0.41666)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308)))); }
void main() {
    #include <beginnormal_vertex>
    #include <defaultnormal_vertex>
    #include <begin_vertex>
    #include <project_vertex>
    #include <worldpos_vertex>
    #include <shadowmap_vertex>
    #include <fog_vertex>
    vec3 facing = normalize(transformNormalByInverseViewMatrix(transformedNormal, viewMatrix));
    vec3 sky = 0.11 + 0.41 * mix(vec3(0.48, 0.43, 0.37), vec3(0.82, 0.89, 1.0), 0.5 + 0.5 * facing.z);
    vec3 sun = 0.76 * vec3(1.0, 0.90, 0.74) * max(0.0, dot(facing, sun_direction));
    in_shadow = srgb(min(vec3(1.0), instanceColor * sky));
    in_sun = srgb(min(vec3(1.0), instanceColor * (sky + sun)));
}`;

const kFragment = `
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
varying vec3 in_sun, in_shadow;
void main() {
    gl_FragColor = vec4(mix(in_shadow, in_sun, getShadowMask()), 1.0);
    #include <fog_fragment>
}`;

export function paint(parameters) {
    const material = new ShaderMaterial({
        vertexShader: kVertex, fragmentShader: kFragment, lights: true, fog: true, toneMapped: false, ...parameters,
        uniforms: UniformsUtils.merge([UniformsLib.lights, UniformsLib.fog, {sun_direction: {value: kSunDirection}}]),
    });
    return material;
}
