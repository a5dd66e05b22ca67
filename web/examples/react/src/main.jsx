// A scene that streams in, with react-three-fiber: `useLoader` knows the loader like any other of three.js.

import { Canvas, useFrame, useLoader } from '@react-three/fiber';
import { Suspense, useEffect, useMemo } from 'react';
import { createRoot } from 'react-dom/client';
import { AnimationMixer } from 'three';
import { StriataLoader, studioEnvironment } from 'striata';

function Model({ url }) {
  const scene = useLoader(StriataLoader, url);
  const mixer = useMemo(() => new AnimationMixer(scene), [scene]);
  useEffect(() => {
    scene.animations[0] && mixer.clipAction(scene.animations[0]).play();
    window.model = scene;
  }, [scene, mixer]);
  useFrame((_, seconds) => mixer.update(seconds));
  return <primitive object={scene} />;
}

function App() {
  const url = new URLSearchParams(location.search).get('model') ?? 'model.stri';
  const environment = useMemo(() => studioEnvironment(), []);
  return (
    <Canvas flat camera={{ position: [0, 2, 9], fov: 40 }} scene={{ environment }}>
      <Suspense fallback={null}>
        <Model url={url} />
      </Suspense>
    </Canvas>
  );
}

createRoot(document.getElementById('root')).render(<App />);
